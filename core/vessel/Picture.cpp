#include "core/vessel/Picture.h"

#include <algorithm>

namespace sagara::core {
namespace {

const config::Range kModelLength{-1e4, 1e4, "m"};

ModelAxis readAxis(config::Reader& in, const char* key) {
    return in.choice<ModelAxis>(
        key,
        {{"+x", {0, 1}}, {"-x", {0, -1}}, {"+y", {1, 1}}, {"-y", {1, -1}}, {"+z", {2, 1}}, {"-z", {2, -1}}});
}

/// A file below assets/models and nowhere else.
bool isInside(const std::string& file) {
    return !file.starts_with('/') && file.find("..") == std::string::npos &&
           file.find('\\') == std::string::npos;
}

void readFit(config::Reader& in, Picture& p) {
    if (in.has("scale") == in.has("fit")) {
        in.problem("scale", in.has("scale") ? "stands beside \"fit\"" : "is missing",
                   "either \"scale\" or \"fit\"");
    }
    if (in.has("scale")) {
        p.fit = Picture::Fit::Scale;
        p.scale = in.number("scale", {1e-4, 1e4, ""});
    }
    if (in.has("fit")) {
        p.fit = in.choice<Picture::Fit>(
            "fit", {{"length", Picture::Fit::Length}, {"length-and-beam", Picture::Fit::LengthAndBeam}});
    }
}

void readLights(config::Reader& in, Picture& p) {
    for (const config::Node& node : in.listOr("lights")) {
        config::Reader light(node);
        const auto place =
            light.choiceIfKnown<LightPlace>("kind", {{"masthead-forward", LightPlace::MastheadForward},
                                                     {"masthead-aft", LightPlace::MastheadAft},
                                                     {"port", LightPlace::Port},
                                                     {"starboard", LightPlace::Starboard},
                                                     {"stern", LightPlace::Stern},
                                                     {"anchor-forward", LightPlace::AnchorForward},
                                                     {"anchor-aft", LightPlace::AnchorAft}});
        const Picture::Light at{light.number("forward_m", kModelLength),
                                light.number("starboard_m", kModelLength),
                                light.number("height_m", {0.0, 1e4, "m"})};
        light.rejectUnknownKeys();
        if (!place) continue;
        auto& known = p.lights[static_cast<std::size_t>(*place)];
        if (known) light.problem("kind", "is \"" + light.text("kind") + "\" again", "each kind once");
        known = at;
    }
}

void readPaints(config::Reader& in, Picture& p) {
    for (const config::Node& node : in.listOr("paints")) {
        config::Reader item(node);
        Picture::Paint paint;
        paint.objects = item.texts("objects");
        if (item.has("rgb")) {
            const std::vector<double> rgb = item.numbers("rgb", 3, {0.0, 255.0, ""});
            paint.colour = {rgb[0] / 255.0, rgb[1] / 255.0, rgb[2] / 255.0};
        }
        paint.texture = item.flagOr("texture", true);
        item.rejectUnknownKeys();
        p.paints.push_back(std::move(paint));
    }
}

}  // namespace

Picture readPicture(config::Reader& in) {
    Picture p;
    p.model = in.text("model");
    if (!isInside(p.model)) in.problem("model", "is \"" + p.model + "\"", "a file in assets/models");
    p.licence = in.text("licence");
    p.forward = readAxis(in, "forward");
    p.up = readAxis(in, "up");
    if (in.sound() && p.forward.axis == p.up.axis)
        in.problem("up", "lies along \"forward\"", "another axis than \"forward\"");
    readFit(in, p);
    p.waterline_m = in.number("waterline_m", kModelLength);
    if (in.has("midship_m")) p.midship_m = in.number("midship_m", kModelLength);
    const auto names = [&](const char* key) {
        return in.has(key) ? in.texts(key) : std::vector<std::string>();
    };
    p.leaveOut = names("leaveOut");
    p.aroundBridge = names("aroundBridge");
    p.detail = names("detail");
    readPaints(in, p);
    readLights(in, p);
    p.provenance = readProvenance(in);
    in.rejectUnknownKeys();
    return p;
}

Result<Picture, config::Problems> loadPicture(const std::string& name, std::string_view text) {
    config::Document document(name, text);
    if (!document.isKind("picture", kPictureDocumentVersion)) return document.problems();
    config::Reader in(document.root());
    in.text("document");
    in.integer("version", 1, kPictureDocumentVersion);
    in.id("id");
    in.text("name");
    return document.finish(readPicture(in));
}

}  // namespace sagara::core
