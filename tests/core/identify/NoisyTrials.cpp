#include "NoisyTrials.h"

#include <cmath>
#include <stdexcept>

#include "core/base/Random.h"
#include "core/base/Units.h"

namespace sagara::test {

using core::kDegree_rad;

Noise::Noise(std::uint64_t seed) : m_seed(seed) {}

double Noise::operator()() {
    core::Random random(m_seed);
    const double u = 1.0 - random.uniform(), v = random.uniform();
    m_seed = random.next();
    return std::sqrt(-2.0 * std::log(u)) * std::cos(core::kTwoPi * v);
}

core::SeaTrial recorded(const core::Trial& run, const std::string& header, Noise& noise) {
    core::Trial noisy = run;
    for (core::TrialSample& s : noisy.samples) {
        s.x_m += 0.01 * run.length_m * noise();
        s.y_m += 0.01 * run.length_m * noise();
        s.heading_rad += 0.3 * kDegree_rad * noise();
        s.surge_mps += 0.05 * noise();
        s.sway_mps += 0.05 * noise();
        s.yawRate_radps += 0.01 * kDegree_rad * noise();
        s.roll_rad += 0.2 * kDegree_rad * noise();
    }
    const auto trial = core::readSeaTrial(run.title, header + core::trialCsv(noisy));
    if (!trial) throw std::runtime_error(trial.error().text());
    return *trial;
}

}  // namespace sagara::test
