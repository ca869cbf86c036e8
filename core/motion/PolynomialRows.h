#pragma once

#include <vector>

#include "core/motion/Actuators.h"
#include "core/motion/Load.h"
#include "core/motion/ShipMotion.h"
#include "core/vessel/Vessel.h"

namespace sagara::core {

/// The rows of a published polynomial at work: the sum of its products in the units of the set, made SI.
class PolynomialRows {
public:
    PolynomialRows(const PolynomialModel& model, const Vessel& vessel);

    /// Rows with the rudder angle belong to the rudder, those with the shaft speed to the propeller.
    /// `crossFlow`: share of the rows marked so.
    HullForces at(const ShipMotion& m, const Actuators& actuators, double depth_m, double crossFlow) const;

    /// z = T / (h - T), held below the least depth; 0 where the set knows no depth.
    double depthParameter(double depth_m) const;
    /// SI values of one unit of the set: force per speed squared, and the length it counts in. A mass of the
    /// set is force x length, an inertia force x length^3.
    double force_kgpm() const { return m_force_kgpm; }
    double length_m() const { return m_scale.length_m; }

private:
    struct Row {
        PolynomialTerm term;
        Load HullForces::*part;
    };
    double unitSpeed_mps(const ShipMotion& m) const;

    PolynomialScale m_scale;
    double m_force_kgpm;
    double m_bisSpeed_mps;
    double m_draught_m, m_leastDepthRatio;
    double m_inflow_m, m_inflow_m2;
    std::size_t m_shafts;
    std::vector<Row> m_rows;
};

}  // namespace sagara::core
