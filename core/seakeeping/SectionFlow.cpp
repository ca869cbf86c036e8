#include "core/seakeeping/SectionFlow.h"

#include <Eigen/QR>
#include <array>
#include <cmath>
#include <numbers>

#include "core/seakeeping/WaveSource.h"

namespace sagara::core {
namespace {

using Complex = std::complex<double>;
constexpr std::array<double, 5> kInnerPoints{0.13, 0.35, 0.57, 0.77, 0.93};  ///< of the half breadth

/// What depends on the node alone, for one field point z: w = z - conj(c) and what goes with it.
struct Node {
    Complex plain;   ///< z - c
    Complex first;   ///< image and standing wave: f(w), whose differences make the normal derivative
    Complex second;  ///< its integral over w
    Complex wave;    ///< exp(u), the radiated part
};

Node nodeAt(Complex z, Complex c, double nu) {
    Node n;
    n.plain = z - c;
    const Complex w = z - std::conj(c);
    const Complex iw(-w.imag(), w.real());
    const Complex log = std::log(iw) - Complex(0.0, 0.5 * std::numbers::pi);  // the cut above the water
    n.first = -log;
    n.second = w - w * log;
    if (nu == 0.0) {  // a wall
        n.first = -n.first;
        n.second = -n.second;
    } else if (std::isfinite(nu)) {
        const Complex u = -nu * iw;
        const Complex F = waveIntegral(u);
        n.first += 2.0 * F;
        n.second += 2.0 * Complex(0.0, 1.0 / nu) * (F - log);
        n.wave = std::exp(u);
    }
    return n;
}

/// Integrals over one panel of Green's function and of its normal derivative at the panel.
struct Influence {
    Complex source;
    Complex doublet;
};

Influence influenceOf(const Node& a, const Node& b, Complex tangent, double nu, bool onPanel) {
    const Complex left = -a.plain / tangent, right = -b.plain / tangent;  // along the panel, from the point
    const double plain = (right * std::log(right) - right - left * std::log(left) + left).real();
    const double angle = onPanel ? 0.0 : std::arg(right * std::conj(left));
    const double image = (-(b.second - a.second) / std::conj(tangent)).real();
    const Complex dWave = b.wave - a.wave;
    const double radiated =
        nu > 0.0 && std::isfinite(nu) ? (-dWave * Complex(0.0, 1.0 / nu) / std::conj(tangent)).real() : 0.0;
    const double by2pi = 0.5 / std::numbers::pi;
    return {{by2pi * (plain + image), radiated},
            {by2pi * (angle - (b.first - a.first).imag()), -dWave.imag()}};
}

Complex toComplex(SectionPoint p) { return {p.y_m, p.z_m}; }

struct System {
    Eigen::MatrixXcd source;
    Eigen::MatrixXcd doublet;
};

/// Rows: panels, then inner points; the influence of both halves, the other one with `sign`.
void fillRow(const std::vector<SectionPanel>& panels, Complex z, double nu, Eigen::Index row, bool onPanel,
             System& even, System& odd) {
    const Complex mirrored(-z.real(), z.imag());
    Node a = nodeAt(z, toComplex(panels[0].from), nu), am = nodeAt(mirrored, toComplex(panels[0].from), nu);
    for (std::size_t j = 0; j < panels.size(); ++j) {
        const Complex to = toComplex(panels[j].to);
        const Complex tangent(-panels[j].normalZ, panels[j].normalY);
        const Node b = nodeAt(z, to, nu), bm = nodeAt(mirrored, to, nu);
        const Eigen::Index column = static_cast<Eigen::Index>(j);
        const Influence own = influenceOf(a, b, tangent, nu, onPanel && row == column);
        const Influence other = influenceOf(am, bm, tangent, nu, false);
        even.source(row, column) = own.source + other.source;
        even.doublet(row, column) = own.doublet + other.doublet;
        odd.source(row, column) = own.source - other.source;
        odd.doublet(row, column) = own.doublet - other.doublet;
        a = b;
        am = bm;
    }
    if (onPanel) {
        even.doublet(row, row) += 0.5;
        odd.doublet(row, row) += 0.5;
    }
}

std::vector<Complex> toList(const Eigen::VectorXcd& v) { return {v.data(), v.data() + v.size()}; }

}  // namespace

SectionFlow flowAbout(const std::vector<SectionPanel>& panels, double waveNumber_radpm) {
    const double halfBreadth_m = panels.back().to.z_m > -1e-9 ? panels.back().to.y_m : 0.0;
    const bool surfacePiercing =
        halfBreadth_m > 0.0 && waveNumber_radpm > 0.0 && std::isfinite(waveNumber_radpm);
    const Eigen::Index n = static_cast<Eigen::Index>(panels.size());
    const Eigen::Index inner = surfacePiercing ? static_cast<Eigen::Index>(kInnerPoints.size()) : 0;
    System even{Eigen::MatrixXcd(n + inner, n), Eigen::MatrixXcd(n + inner, n)}, odd = even;
    for (Eigen::Index i = 0; i < n; ++i)
        fillRow(panels, toComplex(panels[static_cast<std::size_t>(i)].middle), waveNumber_radpm, i, true,
                even, odd);
    for (Eigen::Index i = 0; i < inner; ++i) {
        const double y_m = kInnerPoints[static_cast<std::size_t>(i)] * halfBreadth_m;
        fillRow(panels, {y_m, 0.0}, waveNumber_radpm, n + i, false, even, odd);
    }
    Eigen::VectorXcd heave(n);
    Eigen::MatrixXcd swayRoll(n, 2);
    for (Eigen::Index i = 0; i < n; ++i) {
        const SectionPanel& p = panels[static_cast<std::size_t>(i)];
        heave(i) = p.normalZ;
        swayRoll(i, 0) = p.normalY;
        swayRoll(i, 1) = p.normalRoll_m();
    }
    const Eigen::VectorXcd up = even.doublet.householderQr().solve(even.source * heave);
    const Eigen::MatrixXcd across = odd.doublet.householderQr().solve(odd.source * swayRoll);
    return {toList(across.col(0)), toList(up), toList(across.col(1))};
}

SectionRadiation radiationOf(const std::vector<SectionPanel>& panels, const SectionFlow& flow) {
    Complex sway, heave, roll, swayRoll;
    for (std::size_t i = 0; i < panels.size(); ++i) {
        const SectionPanel& p = panels[i];
        sway += flow.sway_m[i] * p.normalY * p.length_m;
        heave += flow.heave_m[i] * p.normalZ * p.length_m;
        roll += flow.roll_m2[i] * p.normalRoll_m() * p.length_m;
        swayRoll += 0.5 * (flow.roll_m2[i] * p.normalY + flow.sway_m[i] * p.normalRoll_m()) * p.length_m;
    }
    // The integral of psi n over both halves is -a + i b / w.
    return {{-2.0 * sway.real(), -2.0 * heave.real(), -2.0 * roll.real(), -2.0 * swayRoll.real()},
            {2.0 * sway.imag(), 2.0 * heave.imag(), 2.0 * roll.imag(), 2.0 * swayRoll.imag()}};
}

}  // namespace sagara::core
