#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/Result.h"
#include "core/vessel/Provenance.h"

/// What a ship looks like where a 3D model of her is to be had. Only data: models are read by render/scene,
/// and a ship whose model is not there is drawn from her form.
namespace sagara::core {

inline constexpr int kPictureDocumentVersion = 1;

/// A direction along one of a model's own axes.
struct ModelAxis {
    int axis = 0;  ///< 0 x, 1 y, 2 z
    int sign = 1;
};

/// The navigation lights a picture can place.
enum class LightPlace { MastheadForward, MastheadAft, Port, Starboard, Stern, AnchorForward, AnchorAft };
inline constexpr std::size_t kLightPlaces = 7;

/// Of one model. Its lengths are metres of the model, before it is scaled.
struct Picture {
    enum class Fit {
        Scale,         ///< by `scale`, whoever carries it
        Length,        ///< to the ship's length overall, all of it alike
        LengthAndBeam  ///< lengthwise to her length; athwart and upward to her beam
    };
    struct Light {
        double forward_m = 0.0;    ///< of the model's midship
        double starboard_m = 0.0;  ///< of its centreline
        double height_m = 0.0;     ///< above its waterline
    };
    /// Mends the colours of objects.
    struct Paint {
        std::vector<std::string> objects;             ///< names, as below
        std::optional<std::array<double, 3>> colour;  ///< red, green, blue, 0 to 1; none: the file's
        bool texture = true;                          ///< kept where it has one
    };
    std::string model;  ///< file, relative to assets/models
    std::string licence;
    ModelAxis forward;
    ModelAxis up{1, 1};
    Fit fit = Fit::Length;
    double scale = 1.0;               ///< metres per unit of the model, where it is not fitted
    double waterline_m = 0.0;         ///< along `up`
    std::optional<double> midship_m;  ///< along `forward`; not given: the middle of its length
    // Names of objects in the file, '*' for any letters; what is inside an object goes with it.
    std::vector<std::string> leaveOut;
    std::vector<std::string> aroundBridge;  ///< not shown from her own bridge
    std::vector<std::string> detail;        ///< not shown from far off
    std::vector<Paint> paints;              ///< the first that names an object holds
    std::array<std::optional<Light>, kLightPlaces> lights;
    Provenance provenance;
};

/// Members of a vessel's group "picture", and of a picture document beside its "id" and "name".
Picture readPicture(config::Reader& in);

/// A document of kind "picture", which targets name: assets/pictures/ID.json.
Result<Picture, config::Problems> loadPicture(const std::string& name, std::string_view text);

}  // namespace sagara::core
