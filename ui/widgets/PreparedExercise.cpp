#include "ui/widgets/PreparedExercise.h"

namespace sagara::ui {
namespace {

constexpr double kUnderKeel_m = 1.5;  ///< added to the draught
constexpr double kUsual_m = 5.0;
constexpr std::uint64_t kSeed = 1;

}  // namespace

core::Result<PreparedExercise, std::string> prepareExercise(const core::ExerciseDocuments& documents) {
    auto world = core::buildWorld(documents, kSeed);
    if (!world) return world.error().text();
    PreparedExercise prepared;
    prepared.world = std::move(world).value();
    prepared.chart = prepareChart(prepared.world);
    return prepared;
}

std::shared_ptr<const PreparedChart> prepareChart(const std::shared_ptr<const core::World>& world,
                                                  std::size_t ship) {
    const bool floats = ship < world->ships.size();
    const double safety_m = floats ? world->ships[ship]->vessel.hull.draught_m + kUnderKeel_m : kUsual_m;
    return prepareChart(std::shared_ptr<const core::Area>(world, &world->area), safety_m);
}

}  // namespace sagara::ui
