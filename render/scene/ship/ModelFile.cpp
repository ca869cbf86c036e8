#include "render/scene/ship/ModelFile.h"

#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/DefaultLogger.hpp>
#include <assimp/Importer.hpp>
#include <assimp/LogStream.hpp>
#include <cmath>
#include <map>

namespace sagara::render {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostBytes = 32u << 20;
constexpr std::size_t kMostVertices = 200'000;
constexpr int kDeepest = 100;
constexpr float kSmoothBelow_deg = 40.0f;

/// Importers mend much of what is broken and only log it; for us the file is then no good.
class ErrorsOf final : public Assimp::LogStream {
public:
    explicit ErrorsOf(std::string& first) : m_first(first) {}
    void write(const char* message) override {
        if (m_first.empty()) m_first = message;
    }

private:
    std::string& m_first;
};

/// Assimp's log while a file is read; it deletes the stream.
class Log {
public:
    explicit Log(std::string& first) {
        Assimp::DefaultLogger::create("", Assimp::Logger::NORMAL, 0);
        Assimp::DefaultLogger::get()->attachStream(new ErrorsOf(first), Assimp::Logger::Err);
    }
    ~Log() { Assimp::DefaultLogger::kill(); }
    Log(const Log&) = delete;
    Log& operator=(const Log&) = delete;
};

aiVector3D unit(const core::ModelAxis& a) {
    aiVector3D v;
    v[static_cast<unsigned>(a.axis)] = static_cast<ai_real>(a.sign);
    return v;
}

/// The model's axes as the ship's.
struct Axes {
    aiVector3D forward, starboard, up;
    explicit Axes(const core::Picture& p)
        : forward(unit(p.forward)), starboard(unit(p.forward) ^ unit(p.up)), up(unit(p.up)) {}
    Point operator()(const aiVector3D& v) const {
        return {static_cast<double>(v * forward), static_cast<double>(v * starboard),
                static_cast<double>(v * up)};
    }
};

bool anyMatches(const std::vector<std::string>& patterns, const std::string& name) {
    return std::any_of(patterns.begin(), patterns.end(),
                       [&](const std::string& p) { return matches(p, name); });
}
bool finite(Point p) { return std::isfinite(p.x + p.y + p.up); }
Point stretched(Point p, Point by) { return {p.x * by.x, p.y * by.y, p.up * by.up}; }

/// Takes the triangles of a scene apart by where they belong, then brings them to the ship's size.
class Collector {
public:
    Collector(const aiScene& scene, const core::Picture& picture, fs::path folder)
        : m_scene(scene), m_picture(picture), m_folder(std::move(folder)), m_axes(picture) {}

    /// What is the matter, or nothing.
    std::string collect() {
        visit(*m_scene.mRootNode, aiMatrix4x4(), {}, 0);
        if (m_trouble.empty() && m_vertices == 0) m_trouble = "has no triangles that are not left out";
        return m_trouble;
    }
    core::Result<ShipModel, std::string> fitted(double length_m, double beam_m);

private:
    enum class Place { Hull, AroundBridge, Detail };
    struct Skin {
        Paint paint;
        std::shared_ptr<const TextureImage> texture;
    };

    /// What an object has from its name, or from the object it is in.
    struct Manner {
        Place place = Place::Hull;
        const core::Picture::Paint* paint = nullptr;
    };
    Manner mannerOf(const std::string& name, Manner manner) const;
    void visit(const aiNode& node, const aiMatrix4x4& parent, Manner inherited, int depth);
    void take(const aiMesh& mesh, const aiMatrix4x4& at, Manner manner);
    Skin skinOf(const aiMaterial& material, const core::Picture::Paint* paint);
    std::shared_ptr<const TextureImage> textureOf(const std::string& path);
    Solid& solidFor(Place place, const Skin& skin, std::vector<std::array<float, 2>>*& places);

    const aiScene& m_scene;
    const core::Picture& m_picture;
    fs::path m_folder;
    Axes m_axes;
    ShipShape m_shape;
    std::map<std::string, std::shared_ptr<const TextureImage>> m_textures;
    std::size_t m_vertices = 0;
    std::string m_trouble;
};

Collector::Manner Collector::mannerOf(const std::string& name, Manner manner) const {
    if (anyMatches(m_picture.aroundBridge, name)) manner.place = Place::AroundBridge;
    if (anyMatches(m_picture.detail, name)) manner.place = Place::Detail;
    const auto paint = std::find_if(m_picture.paints.begin(), m_picture.paints.end(),
                                    [&](const auto& p) { return anyMatches(p.objects, name); });
    if (paint != m_picture.paints.end()) manner.paint = &*paint;
    return manner;
}

void Collector::visit(const aiNode& node, const aiMatrix4x4& parent, Manner inherited, int depth) {
    const std::string name = node.mName.C_Str();
    if (anyMatches(m_picture.leaveOut, name)) return;
    if (depth > kDeepest) m_trouble = "has objects in objects deeper than " + std::to_string(kDeepest);
    const aiMatrix4x4 at = parent * node.mTransformation;
    const Manner manner = mannerOf(name, inherited);
    for (unsigned i = 0; i < node.mNumMeshes && m_trouble.empty(); ++i)
        take(*m_scene.mMeshes[node.mMeshes[i]], at, manner);
    for (unsigned i = 0; i < node.mNumChildren && m_trouble.empty(); ++i)
        visit(*node.mChildren[i], at, manner, depth + 1);
}

std::shared_ptr<const TextureImage> Collector::textureOf(const std::string& path) {
    // Paths of the author's disk: the file lies beside the model.
    const std::string file = path.substr(path.find_last_of("/\\") + 1);
    auto& texture = m_textures[file];
    if (!texture) {
        auto read = readTexture(m_folder / file);
        if (!read) m_trouble = "names a " + read.error();
        if (read) texture = std::make_shared<const TextureImage>(std::move(read).value());
    }
    return texture;
}

Collector::Skin Collector::skinOf(const aiMaterial& material, const core::Picture::Paint* paint) {
    aiColor3D c(0.7f, 0.7f, 0.7f);
    material.Get(AI_MATKEY_COLOR_DIFFUSE, c);
    Skin skin{{static_cast<double>(c.r), static_cast<double>(c.g), static_cast<double>(c.b)}, {}};
    if (paint && paint->colour) skin.paint = {(*paint->colour)[0], (*paint->colour)[1], (*paint->colour)[2]};
    aiString path;
    const bool textured = material.GetTexture(aiTextureType_DIFFUSE, 0, &path) == aiReturn_SUCCESS;
    if (!textured || (paint && !paint->texture)) return skin;
    skin.texture = textureOf(path.C_Str());
    if (!skin.texture) return skin;
    if (const auto only = skin.texture->onlyColour()) {
        const Paint p = skin.paint;
        skin.paint = {p.red * only->red, p.green * only->green, p.blue * only->blue};
        skin.texture.reset();
    }
    return skin;
}

Solid& Collector::solidFor(Place place, const Skin& skin, std::vector<std::array<float, 2>>*& places) {
    places = nullptr;
    if (!skin.texture)
        return place == Place::Hull     ? m_shape.hull
               : place == Place::Detail ? m_shape.detail
                                        : m_shape.upperworks;
    auto& list = place == Place::Hull     ? m_shape.textured.hull
                 : place == Place::Detail ? m_shape.textured.detail
                                          : m_shape.textured.upperworks;
    auto found = std::find_if(list.begin(), list.end(),
                              [&](const TexturedSolid& t) { return t.texture == skin.texture; });
    if (found == list.end()) found = list.insert(list.end(), {{}, {}, skin.texture});
    places = &found->places;
    return found->solid;
}

void Collector::take(const aiMesh& mesh, const aiMatrix4x4& at, Manner manner) {
    m_vertices += mesh.mNumVertices;
    if (m_vertices > kMostVertices) {
        m_trouble = "has more than " + std::to_string(kMostVertices) + " vertices";
        return;
    }
    Skin skin = skinOf(*m_scene.mMaterials[mesh.mMaterialIndex], manner.paint);
    if (!mesh.HasTextureCoords(0)) skin.texture.reset();
    std::vector<std::array<float, 2>>* places = nullptr;
    Solid& solid = solidFor(manner.place, skin, places);
    aiMatrix3x3 turn(at);
    turn.Inverse().Transpose();
    const auto first = static_cast<std::uint32_t>(solid.vertices.size());
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
        const Point p = m_axes(at * mesh.mVertices[i]);
        if (!finite(p)) {
            m_trouble = "has a vertex that is no number";
            return;
        }
        Point n = mesh.HasNormals() ? m_axes(turn * mesh.mNormals[i]) : Point{0.0, 0.0, 1.0};
        if (!finite(n)) n = {0.0, 0.0, 1.0};  // of a triangle without an area
        solid.vertices.push_back({p, n, skin.paint});
        if (places) places->push_back({mesh.mTextureCoords[0][i].x, 1.0f - mesh.mTextureCoords[0][i].y});
    }
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        const aiFace& face = mesh.mFaces[f];
        if (face.mNumIndices != 3) continue;  // a line or a point
        for (unsigned k = 0; k < 3; ++k) solid.indices.push_back(first + face.mIndices[k]);
    }
}

core::Result<ShipModel, std::string> Collector::fitted(double length_m, double beam_m) {
    std::vector<Solid*> all{&m_shape.hull, &m_shape.upperworks, &m_shape.detail};
    for (auto* list : {&m_shape.textured.hull, &m_shape.textured.upperworks, &m_shape.textured.detail})
        for (TexturedSolid& t : *list) all.push_back(&t.solid);
    Point low{1e30, 1e30, 1e30}, high{-1e30, -1e30, -1e30};
    for (const Solid* solid : all) {
        for (const SolidVertex& v : solid->vertices) {
            low = {std::min(low.x, v.position.x), std::min(low.y, v.position.y), 0.0};
            high = {std::max(high.x, v.position.x), std::max(high.y, v.position.y), 0.0};
        }
    }
    const double length = high.x - low.x, beam = high.y - low.y;
    if (!(length > 1e-3 && beam > 1e-3 && length < 1e6 && beam < 1e6))
        return std::string("has no length or beam");
    using Fit = core::Picture::Fit;
    const double along = m_picture.fit == Fit::Scale ? m_picture.scale : length_m / length;
    const double across = m_picture.fit == Fit::LengthAndBeam ? beam_m / beam : along;
    const Point by{along, across, across}, normalBy{1.0 / along, 1.0 / across, 1.0 / across};
    const Point origin{m_picture.midship_m.value_or(0.5 * (low.x + high.x)), 0.0, m_picture.waterline_m};
    for (Solid* solid : all) {
        for (SolidVertex& v : solid->vertices) {
            v.position = stretched(v.position - origin, by);
            v.normal = normalised(stretched(v.normal, normalBy));
        }
    }
    ShipModel model{std::move(m_shape), {}};
    for (std::size_t i = 0; i < core::kLightPlaces; ++i) {
        if (const auto& light = m_picture.lights[i])
            model.lights[i] = stretched({light->forward_m, light->starboard_m, light->height_m}, by);
    }
    return model;
}

std::string lineOf(std::string message) {
    while (!message.empty() && std::isspace(static_cast<unsigned char>(message.back()))) message.pop_back();
    return message;
}

}  // namespace

bool matches(const std::string& pattern, const std::string& name) {
    // Greedy, going back to the last star.
    std::size_t p = 0, n = 0, star = std::string::npos, from = 0;
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            from = n;
        } else if (p < pattern.size() && pattern[p] == name[n]) {
            ++p;
            ++n;
        } else if (star != std::string::npos) {
            p = star + 1;
            n = ++from;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', p) == std::string::npos;
}

core::Result<ShipModel, std::string> readModel(const fs::path& models, const core::Picture& picture,
                                               double length_m, double beam_m) {
    const fs::path file = models / picture.model;
    const auto trouble = [&](const std::string& what) { return "model " + file.string() + " " + what; };
    std::error_code error;
    const std::uintmax_t bytes = fs::is_regular_file(file, error) ? fs::file_size(file, error) : 0;
    if (bytes == 0) return trouble("is not there or empty");
    if (bytes > kMostBytes)
        return trouble("has " + std::to_string(bytes) + " bytes, expected at most " +
                       std::to_string(kMostBytes));

    std::string logged;
    const Log log(logged);
    Assimp::Importer importer;
    importer.SetPropertyFloat(AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, kSmoothBelow_deg);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_AC_SEPARATE_BFCULL, false);
    importer.SetPropertyBool(AI_CONFIG_IMPORT_AC_EVAL_SUBDIVISION, false);
    const aiScene* scene = importer.ReadFile(
        file.string(), aiProcess_Triangulate | aiProcess_GenSmoothNormals | aiProcess_JoinIdenticalVertices |
                           aiProcess_ValidateDataStructure);
    if (scene == nullptr) return trouble("cannot be read: " + lineOf(importer.GetErrorString()));
    if (!logged.empty()) return trouble("is broken: " + lineOf(logged));
    if (scene->mRootNode == nullptr || scene->mNumMeshes == 0) return trouble("has no triangles");
    Collector collector(*scene, picture, file.parent_path());
    if (const std::string what = collector.collect(); !what.empty()) return trouble(what);
    auto model = collector.fitted(length_m, beam_m);
    if (!model) return trouble(model.error());
    return model;
}

}  // namespace sagara::render
