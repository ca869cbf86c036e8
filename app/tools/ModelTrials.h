#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/tools/WaveTrial.h"
#include "core/identify/Trial.h"

namespace sagara::tools {

/// What every model of a comparison is asked to do.
struct ModelTask {
    double speed_mps = 0.0;
    double rudder_deg = 35.0;
    double zigzag_deg = 20.0;
    double shallowDepthOverDraught = 1.2;
    double waveAmplitude_m = 0.5;
    std::vector<double> omegas_radps;  ///< of the waves
};

/// What a model did. Every number is of a run; ratios are to the same run in deep water at full speed.
struct ModelTrials {
    std::string name;
    std::string of;  ///< whose it is
    double length_m = 0.0;
    core::Trial turn, turnPort, zigzag;
    std::optional<double> halfSpeedDiameter;  ///< tactical diameter at half the speed, ratio
    std::optional<double> shallowDiameter;    ///< in shallow water, ratio
    double speedLeft = 0.0;      ///< share of the speed left ten lengths' time after the shafts were stopped
    double yawFromDrift = 0.0;   ///< yaw acceleration over (U/L)^2 when she drifts 5 deg, rudder midship
    double timesRealTime = 0.0;  ///< seconds of the turn a second of this machine
    struct InWave {
        double omega_radps, lambdaOverL;
        WaveAnswer head, beam;
    };
    std::vector<InWave> waves;
};

/// `hull`: of the vessel, ready for the sea.
ModelTrials runModelTrials(const std::string& name, const core::Vessel& vessel, const std::string& model,
                           const ModelTask& task, const std::shared_ptr<const core::SeaHull>& hull);

}  // namespace sagara::tools
