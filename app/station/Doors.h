#pragma once

#include "app/station/Frame.h"

/// Which pages there are and how one leads to another.
namespace sagara::station {

class Station;

/// The doors, and what is to be decided first: runs that were broken off or could not be filed.
ui::Page* homePage(Station& station);
/// Choosing a lesson for the trainer's desk.
ui::Page* lessonPage(Station& station);
/// The same for a trainee who sails it from her own console.
ui::Page* watchPage(Station& station);
/// Sailing alone.
ui::Page* alonePage(Station& station);

/// The vessels: the admin's first page.
ui::Page* adminPage(Station& station);

/// What the command line asks for: a role's door, or at once an exercise. The error is for the person.
std::optional<std::string> enter(Station& station, const std::string& role, const RunRequest& request);
/// With a wall of that layout beside it; empty: none.
std::optional<std::string> enterDemo(Station& station, const std::string& wallLayout = {});

void about(Station& station);

}  // namespace sagara::station
