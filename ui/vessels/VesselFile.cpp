#include "ui/vessels/VesselFile.h"

#include <QByteArray>
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/vessel/CompleteVessel.h"
#include "core/vessel/Vessel.h"

namespace sagara::ui {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kKind = "vessel-export";
constexpr int kVersion = 1;
constexpr std::uintmax_t kMostBytes = 40u << 20;

std::optional<std::string> bytesOf(const fs::path& file) {
    std::error_code trouble;
    if (fs::file_size(file, trouble) > kMostBytes || trouble) return std::nullopt;
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in) return std::nullopt;
    return text.str();
}

/// A path that stays below the folder it is joined to.
bool staysInside(const std::string& path) {
    return !path.empty() && path.front() != '/' && path.find("..") == std::string::npos &&
           path.find('\\') == std::string::npos && path.find(':') == std::string::npos;
}

std::string modelOf(const std::string& vesselText) {
    const Json json = Json::parse(vesselText, nullptr, false);
    if (!json.is_object() || !json.contains("picture") || !json["picture"].is_object()) return {};
    const Json& model = json["picture"].contains("model") ? json["picture"]["model"] : Json();
    return model.is_string() ? model.get<std::string>() : std::string();
}

}  // namespace

std::string vesselFileText(const VesselFile& file) {
    Json json{{"document", kKind}, {"version", kVersion}};
    json["vessel"] = Json::parse(file.text, nullptr, false);
    json["files"] = Json::array();
    for (const AttachedFile& f : file.files) {
        const QByteArray coded =
            QByteArray::fromRawData(f.bytes.data(), static_cast<qsizetype>(f.bytes.size())).toBase64();
        json["files"].push_back({{"path", f.path}, {"base64", coded.toStdString()}});
    }
    return json.dump(2) + "\n";
}

core::Result<VesselFile, std::string> readVesselFile(const std::string& name, const std::string& text) {
    VesselFile file;
    const Json json = Json::parse(text, nullptr, false);
    if (json.is_object() && json.value("document", Json()) == kKind) {
        if (json.value("version", Json()) != kVersion)
            return name + ": this export is of another version; version 1 is read";
        file.text = json.value("vessel", Json()).dump(2) + "\n";
        for (const Json& item : json.value("files", Json::array())) {
            const Json path = item.is_object() ? item.value("path", Json()) : Json(),
                       coded = item.is_object() ? item.value("base64", Json()) : Json();
            if (!path.is_string() || !coded.is_string() || !staysInside(path.get<std::string>()))
                return name + ": files: each needs a path below the models folder and its base64";
            const auto bytes = QByteArray::fromBase64Encoding(
                QByteArray::fromStdString(coded.get<std::string>()), QByteArray::AbortOnBase64DecodingErrors);
            if (!bytes) return name + ": files: " + path.get<std::string>() + " is not base64";
            file.files.push_back({path.get<std::string>(), bytes.decoded.toStdString()});
        }
    } else {
        file.text = text;
    }
    const auto vessel = core::loadVessel(name, file.text);
    if (!vessel) return vessel.error().text();
    file.text = core::completeVessel(name, file.text).value();
    return file;
}

std::vector<AttachedFile> attachedFiles(const std::string& vesselText, const fs::path& ownModels) {
    std::vector<AttachedFile> files;
    const std::string model = modelOf(vesselText);
    std::error_code trouble;
    if (model.empty() || !staysInside(model) || !fs::is_regular_file(ownModels / model, trouble))
        return files;
    const fs::path folder = fs::path(model).parent_path();
    for (const auto& entry : fs::directory_iterator(ownModels / folder, trouble)) {
        if (!entry.is_regular_file(trouble)) continue;
        if (auto bytes = bytesOf(entry.path()))
            files.push_back({(folder / entry.path().filename()).generic_string(), std::move(*bytes)});
    }
    std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
    return files;
}

std::optional<std::string> writeAttached(const std::vector<AttachedFile>& files, const fs::path& ownModels) {
    for (const AttachedFile& f : files) {
        const fs::path to = ownModels / f.path;
        std::error_code trouble;
        fs::create_directories(to.parent_path(), trouble);
        std::ofstream out(to, std::ios::binary | std::ios::trunc);
        out.write(f.bytes.data(), static_cast<std::streamsize>(f.bytes.size()));
        out.close();
        if (!out) return to.string() + " cannot be written";
    }
    return std::nullopt;
}

core::Result<std::vector<AttachedFile>, std::string> gatherModel(const fs::path& model,
                                                                 const std::string& vesselId) {
    auto bytes = bytesOf(model);
    if (!bytes) return model.string() + " cannot be read, or is larger than 40 MB";
    const fs::path folder = fs::path("attached") / vesselId;
    std::vector<AttachedFile> files{{(folder / model.filename()).generic_string(), *bytes}};
    // What stands beside it and is named in it, or in what it names: materials, buffers, textures.
    std::error_code trouble;
    std::string names = std::move(*bytes);
    for (int pass = 0; pass < 2; ++pass) {
        for (const auto& entry : fs::directory_iterator(model.parent_path(), trouble)) {
            const std::string name = entry.path().filename().string();
            std::string kind = entry.path().extension().string();
            std::transform(kind.begin(), kind.end(), kind.begin(),
                           [](unsigned char c) { return std::tolower(c); });
            const std::string to = (folder / name).generic_string();
            const bool have =
                std::any_of(files.begin(), files.end(), [&](const auto& f) { return f.path == to; });
            if (have || (kind != ".png" && kind != ".mtl" && kind != ".bin") ||
                names.find(name) == std::string::npos)
                continue;
            auto more = bytesOf(entry.path());
            if (!more) return entry.path().string() + " cannot be read, or is larger than 40 MB";
            if (kind == ".mtl") names += *more;
            files.push_back({to, std::move(*more)});
        }
    }
    return files;
}

std::string renamed(const std::string& vesselText, const std::string& id, const std::string& name) {
    Json json = Json::parse(vesselText, nullptr, false);
    json["id"] = id;
    json["name"] = name;
    return json.dump(2) + "\n";
}

}  // namespace sagara::ui
