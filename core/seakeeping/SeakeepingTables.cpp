#include "core/seakeeping/SeakeepingTables.h"

#include <Eigen/Core>
#include <cassert>

namespace sagara::core {
namespace {

using Complex = std::complex<double>;
using Matrix = Eigen::Matrix<Complex, 6, 6>;

/// w^2 A - i w B: the force that answers a unit motion.
Matrix transfer(const Matrix6& addedMass, const Matrix6& damping, double omega_radps) {
    Matrix t;
    for (int i = 0; i < 6; ++i) {
        for (int j = 0; j < 6; ++j) {
            const std::size_t at = static_cast<std::size_t>(6 * i + j);
            t(i, j) = {omega_radps * omega_radps * addedMass.value[at], -omega_radps * damping.value[at]};
        }
    }
    return t;
}

}  // namespace

AddedMassAndDamping radiationAt(const Radiation& zeroSpeed, double omega_radps, double speed_mps,
                                bool transomTerms) {
    assert(omega_radps > 0.0);
    // Pitching at speed is also heaving against the stream, yawing swaying: potentials (I - s G)^T, forces
    // (I + s G), by Tuck's theorem; the aftmost section ends the integrals with one term more.
    const Complex s = speed_mps / (Complex(0.0, 1.0) * omega_radps);
    Matrix G = Matrix::Zero();
    G(4, 2) = -1.0;
    G(5, 1) = 1.0;
    const Matrix I = Matrix::Identity();
    const Matrix potentials = I - s * G.transpose();
    Matrix t = (I + s * G) * transfer(zeroSpeed.addedMass, zeroSpeed.damping, omega_radps) * potentials;
    if (transomTerms)
        t += s * transfer(zeroSpeed.endAddedMass, zeroSpeed.endDamping, omega_radps) * potentials;
    AddedMassAndDamping at;
    for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t j = 0; j < 6; ++j) {
            const Complex value = t(static_cast<int>(i), static_cast<int>(j));
            at.addedMass(i, j) = value.real() / (omega_radps * omega_radps);
            at.damping(i, j) = -value.imag() / omega_radps;
        }
    }
    return at;
}

}  // namespace sagara::core
