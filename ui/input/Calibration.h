#pragma once

#include <optional>

/// What a raw axis reading means. Raw readings are -1 to 1, as SDL gives them; so are calibrated ones, 0 is
/// the middle.
namespace sagara::ui {

struct AxisCalibration {
    double least = -1.0;
    double centre = 0.0;
    double most = 1.0;
    double deadZone = 0.03;  ///< part of the way around the centre that counts as the middle
    bool inverted = false;
    friend bool operator==(const AxisCalibration&, const AxisCalibration&) = default;
};
inline constexpr double kMostDeadZone = 0.5;
inline constexpr double kLeastTravel = 0.1;  ///< on each side of the centre

/// Finite, in range, least < centre < most by kLeastTravel.
bool usable(const AxisCalibration& calibration);
/// -1 to 1 for any reading, with no step at the edge of the dead zone. Needs a usable calibration.
double calibrated(const AxisCalibration& calibration, double raw);

/// Takes a person through it: first the middle, then both ends.
class CalibrationRun final {
public:
    enum class Step { Middle, Ends, Done };
    explicit CalibrationRun(const AxisCalibration& before) : m_found(before) {}

    void feed(double raw);
    Step step() const { return m_step; }
    /// Ends may be finished: the control has gone far enough both ways.
    bool mayGoOn() const;
    void next();
    const AxisCalibration& found() const { return m_found; }

private:
    AxisCalibration m_found;
    std::optional<double> m_last;
    Step m_step = Step::Middle;
};

/// Lets through what a hand does and not the flicker of a worn potentiometer. The first reading after it was
/// made is only taken note of: a lever gives an order by being moved, not by being plugged in.
class AxisGate final {
public:
    /// The value when it is an order.
    std::optional<double> moved(double value);

private:
    std::optional<double> m_last;
};

}  // namespace sagara::ui
