#pragma once

#include <nlohmann/json.hpp>
#include <string>

/// Places in a document, written as the loaders write them: "route.waypoints[2].at.lat". "" is the document.
namespace sagara::ui::editor {

/// Keeps members in the order they were written and those that nobody here knows.
using Json = nlohmann::ordered_json;

std::string join(const std::string& path, const std::string& key);
std::string join(const std::string& path, std::size_t index);
/// "route.waypoints[2].at" -> "route.waypoints[2]"; "" of a path with one step.
std::string parentOf(const std::string& path);
/// Number in the last brackets of "a[2]"; nothing is assumed of what comes before. 0 when there are none.
std::size_t indexOf(const std::string& path);
/// Whether `path` is `outer` or lies in it.
bool within(const std::string& path, const std::string& outer);

/// Null when there is nothing.
const Json* find(const Json& document, const std::string& path);
/// Objects on the way are made; a list must have the element already.
void put(Json& document, const std::string& path, Json value);
void erase(Json& document, const std::string& path);

/// What is there, or the fallback when it is nothing or of another type.
double numberAt(const Json& document, const std::string& path, double fallback);
std::string textAt(const Json& document, const std::string& path, const std::string& fallback = {});
std::size_t sizeAt(const Json& document, const std::string& path);  ///< of a list; 0 when there is none

}  // namespace sagara::ui::editor
