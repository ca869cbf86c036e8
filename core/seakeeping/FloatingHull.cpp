#include "core/seakeeping/FloatingHull.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace sagara::core {
namespace {

using RowMajor = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;

Matrix6 inverseOfSum(const Matrix6& a, const Matrix6& b) {
    const RowMajor sum =
        Eigen::Map<const RowMajor>(a.value.data()) + Eigen::Map<const RowMajor>(b.value.data());
    Matrix6 inverse;
    Eigen::Map<RowMajor>(inverse.value.data()) = sum.inverse();
    return inverse;
}

Six operator*(const Matrix6& m, const Six& v) {
    Six product{};
    for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) product[i] += m(i, j) * v[j];
    return product;
}

}  // namespace

Six relativeVelocity(const Six& displacement, const Six& rate, double speed_mps) {
    Six v = rate;
    v[1] -= speed_mps * displacement[5];
    v[2] += speed_mps * displacement[4];
    return v;
}

FloatingHull::FloatingHull(const SeakeepingTables& tables, bool transomTerms)
    : m_memory(tables),
      m_transomTerms(transomTerms),
      m_restoring(tables.restoring),
      m_addedMass(tables.addedMassInfinite),
      m_compliance(inverseOfSum(tables.mass, tables.addedMassInfinite)) {}

HullMotion FloatingHull::rate(const HullMotion& motion, const Six& force, double speed_mps,
                              const ViscousRoll& roll) const {
    Six x, dx;
    MemoryState state;
    std::copy_n(motion.value.begin(), 6, x.begin());
    std::copy_n(motion.value.begin() + 6, 6, dx.begin());
    std::copy_n(motion.value.begin() + 12, kMemoryValues, state.begin());
    const Six v = relativeVelocity(x, dx, speed_mps);
    const MemoryState remembered = m_memory.rate(state, v);
    const Six stiff = m_restoring * x, kept = m_memory.momentum(remembered), direct = m_addedMass * v,
              memory = m_memory.momentum(state);
    const Six turning = m_addedMass * relativeVelocity(dx, {}, speed_mps);
    Six sum = force;
    for (std::size_t i = 0; i < 6; ++i) sum[i] -= stiff[i] + kept[i] + turning[i];
    sum[4] += speed_mps * (direct[2] + memory[2]);
    sum[5] -= speed_mps * (direct[1] + memory[1]);
    if (m_transomTerms) {
        const Six end = m_memory.endMomentum(state, v);
        for (std::size_t i = 0; i < 6; ++i) sum[i] -= speed_mps * end[i];
    }
    sum[3] -= (roll.linear_Nms + roll.quadratic_Nms2 * std::abs(dx[3])) * dx[3];
    const Six acceleration = m_compliance * sum;
    HullMotion rate;
    std::copy_n(dx.begin(), 6, rate.value.begin());
    std::copy_n(acceleration.begin(), 6, rate.value.begin() + 6);
    std::copy_n(remembered.begin(), kMemoryValues, rate.value.begin() + 12);
    return rate;
}

}  // namespace sagara::core
