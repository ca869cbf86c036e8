#include "Between.h"
#include "Commands.h"
#include "app/run/RunWall.h"

namespace sagara::sim {

void addWall(Commands& commands) {
    auto o = std::make_shared<run::WallRunOptions>();
    auto helm = std::make_shared<std::string>("none");
    auto size_px = std::make_shared<std::vector<std::uint32_t>>();
    CLI::App* wall =
        commands.add("wall", "run an exercise with its wall, without a station", [=](run::Store& store) {
            o->pilot = *helm == "pilot";
            if (size_px->size() == 2) o->size_px.emplace((*size_px)[0], (*size_px)[1]);
            return run::runWall(store, *o);
        });
    wall->add_option("--scenario", o->scenario, "id in the database, or a file")->required();
    wall->add_option("--layout", o->layout, "id under assets/walls, or a file (desk-3x60)");
    wall->add_option("--helm", *helm, "who sails: the scripted pilot, or nobody")
        ->check(CLI::IsMember({"pilot", "none"}));
    wall->add_option("--level", o->level, "difficulty, 1 to 5 (3)")->check(CLI::Range(1, 5));
    wall->add_option("--seed", o->seed, "of sea and gusts (1)");
    wall->add_option("--start-utc", o->changes.startUtc, "another start, as in 2027-01-15T13:00:00Z");
    wall->add_option("--wind-kn", o->changes.wind_kn, "another wind")->check(between(0.0, 100.0));
    wall->add_option("--visibility-m", o->changes.visibility_m, "another visibility")
        ->check(between(10.0, 100'000.0));
    wall->add_option("--rain", o->changes.rain, "other rain, 0 to 1")->check(between(0.0, 1.0));
    wall->add_option("--at-s", o->at_s, "open after the pilot has sailed so long (0)")
        ->check(between(0.0, 86'400.0));
    wall->add_flag("--fullscreen", o->fullScreen, "each channel over a screen of its own, left to right");
    wall->add_flag("--offscreen", o->offscreen, "channels without windows")->excludes("--fullscreen");
    wall->add_option("--size", *size_px, "of every channel, in pixels: 640x360")
        ->delimiter('x')
        ->expected(2)
        ->check(CLI::Range(64, 4096));
    wall->add_option("--rate-hz", o->rate_Hz, "frames a second at most (60)")->check(CLI::Range(1.0, 240.0));
    wall->add_flag("--fast", o->fast, "frames of 1/rate-hz, as fast as the channels draw");
    wall->add_option("--duration-s", o->duration_s, "of the exercise (10)")
        ->check(CLI::Range(0.0, 7.0 * 86400.0));
    wall->add_option("--shots", o->shots, "folder for pictures of all channels side by side");
    wall->add_option("--shot-every-s", o->shotEvery_s, "time between them (2)")
        ->check(CLI::Range(0.1, 3600.0));
    wall->add_option("--view", o->view, "channel program (else sagara-view beside this one)");
    wall->add_option("--view-option", o->viewArguments,
                     "passed on to it, for example --view-option=--preset=low");
    wall->add_flag("--listen", o->listen, "take channels from other PCs; the token is in SAGARA_TOKEN");
    wall->add_option("--port", o->port, "to listen on (any)");
    wall->add_option("--kill-every-s", o->killEvery_s, "for trials: kill a channel so often")
        ->check(CLI::Range(0.5, 86400.0));
    wall->add_option("--order-every-s", o->orderEvery_s,
                     "for trials: a helm order so often, and how soon it shows")
        ->check(between(0.1, 86'400.0))
        ->excludes("--fast");
}

}  // namespace sagara::sim
