#include "Between.h"
#include "Commands.h"
#include "VesselOptions.h"
#include "app/tools/SeaTool.h"
#include "app/tools/SquatTool.h"
#include "app/tools/WindLoadTool.h"
#include "core/sea/Beaufort.h"

namespace sagara::sim {

void addSea(Commands& commands) {
    auto o = std::make_shared<tools::SeaToolOptions>();
    CLI::App* sea =
        commands.add("sea", "spectrum of a sea, its statistics and those of the surface made of it",
                     [o] { return tools::runSeaTool(*o); });
    sea->add_option("--spectrum", o->spectrum, "(jonswap)")
        ->check(CLI::IsMember({"pierson-moskowitz", "bretschneider", "ittc", "jonswap", "ochi-hubble",
                               "beaufort", "measured"}));
    sea->add_option("--hs", o->order.significantHeight_m, "significant height, m")
        ->check(between(0.01, 30.0));
    sea->add_option("--tp", o->order.peakPeriod_s, "peak period, s (8)")->check(between(1.0, 30.0));
    sea->add_option("--t1", o->order.meanPeriod_s, "mean period, s: ittc")->check(between(1.0, 25.0));
    sea->add_option("--gamma", o->order.gamma, "jonswap (3.3)")->check(between(1.0, 7.0));
    sea->add_option("--wind-mps", o->order.wind_mps, "at 10 m: pierson-moskowitz")->check(between(0.5, 60.0));
    sea->add_option("--beaufort", o->beaufort, "number (5)")->check(between(0, core::kBeaufortMax));
    sea->add_flag("--inshore", o->inshore, "beaufort: a sea of limited fetch");
    sea->add_option("--file", o->file, "measured: a document of waves, such as assets/waves/ndbc-41010.json");
    sea->add_option("--record", o->record, "measured: which of the file, from 0 (0)")
        ->check(between(0, 100'000));
    sea->add_option("--from-deg", o->from_deg, "where it comes from, true (0)")->check(between(0.0, 360.0));
    sea->add_option("--spreading", o->order.spreading, "s of cos^2s (4)")->check(between(1.0, 100.0));
    sea->add_option("--depth-m", o->depth_m, "of the water (deep)")->check(between(1.0, 12'000.0));
    sea->add_option("--seed", o->seed, "of the surface (1)");
    sea->add_option("--omega", o->omega_radps, "w1,w2,... rad/s")->delimiter(',')->check(between(0.01, 50.0));
    sea->add_flag("--measures", o->measures, "print name,value rows instead of the spectrum");
    addCsvOption(*sea, o->csv);
}

void addWindLoad(Commands& commands) {
    auto o = std::make_shared<tools::WindLoadOptions>();
    CLI::App* wind = commands.add("wind-load", "coefficients and loads of a relative wind on a vessel",
                                  [o](run::Store& store) { return tools::runWindLoad(store, *o); });
    addVesselOptions(*wind, o->ship)->required();
    wind->add_option("--wind-mps", o->wind_mps, "relative (10)")->check(between(0.0, 80.0));
    wind->add_option("--from-deg", o->from_deg, "off the bow, 90 from starboard: a1,a2,... (0 to 180)")
        ->delimiter(',')
        ->check(between(-360.0, 360.0));
    addCsvOption(*wind, o->csv);
}

void addSquat(Commands& commands) {
    auto o = std::make_shared<tools::SquatToolOptions>();
    CLI::App* squat =
        commands.add("squat", "sinkage of a vessel under way in shallow water, by four formulas",
                     [o](run::Store& store) { return tools::runSquatTool(store, *o); });
    addVesselOptions(*squat, o->ship)->required();
    squat->add_option("--speed-mps", o->speed_mps, "through the water: v1,v2,...")
        ->required()
        ->delimiter(',')
        ->check(between(0.0, 40.0));
    squat->add_option("--width-m", o->width_m, "of the channel (open water)")->check(between(5.0, 1e5));
    addCsvOption(*squat, o->csv);
}

}  // namespace sagara::sim
