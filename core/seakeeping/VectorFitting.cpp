#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/seakeeping/RadiationMemory.h"

namespace sagara::core {
namespace {

using Complex = std::complex<double>;
constexpr int kOrder = static_cast<int>(2 * kMemoryFilters);
using Basis = std::array<Complex, 2 * kMemoryFilters>;

Basis basisAt(const FilterBank& bank, double omega) {
    const Complex s(0.0, omega);
    Basis basis;
    for (std::size_t k = 0; k < kMemoryFilters; ++k) {
        basis[2 * k] = 1.0 / (s * s + bank[k].damping_perS * s + bank[k].stiffness_perS2);
        basis[2 * k + 1] = s * basis[2 * k];
    }
    return basis;
}

/// The momentum falls off towards high frequencies, where damping is the momentum times the frequency.
double weightAt(double omega) { return std::sqrt(1.0 + 0.25 * omega * omega); }

double greatest(const MemoryCurve& curve) {
    double most = 0.0;
    for (const Complex& v : curve.value) most = std::max(most, std::abs(v));
    return most;
}

/// Two by two, from their poles: conjugates together, real ones by size.
FilterBank fromPoles(const Eigen::VectorXcd& poles) {
    std::vector<MemoryFilter> filters;
    std::vector<double> real;
    for (const Complex& p : poles) {
        if (p.imag() == 0.0) {
            real.push_back(std::max(std::abs(p.real()), 1e-3));
        } else if (p.imag() > 0.0) {
            filters.push_back({std::norm(p), std::max(2.0 * std::abs(p.real()), 0.02 * std::abs(p))});
        }
    }
    std::sort(real.begin(), real.end());
    for (std::size_t i = 0; i + 1 < real.size(); i += 2)
        filters.push_back({real[i] * real[i + 1], real[i] + real[i + 1]});
    FilterBank bank;
    std::copy_n(filters.begin(), kMemoryFilters, bank.begin());
    return bank;
}

/// One step of vector fitting: zeros of sigma, where sigma f and sigma have the poles of `bank`.
FilterBank relocated(const FilterBank& bank, const std::vector<double>& omega,
                     const std::vector<MemoryCurve>& curves) {
    const int width = kOrder + 1, points = static_cast<int>(omega.size());
    const int shared = width * static_cast<int>(curves.size());
    Eigen::MatrixXd M = Eigen::MatrixXd::Zero(2 * points * static_cast<int>(curves.size()), shared + kOrder);
    Eigen::VectorXd right(M.rows());
    int row = 0;
    for (std::size_t e = 0; e < curves.size(); ++e) {
        const double scale = 1.0 / greatest(curves[e]);
        const int first = width * static_cast<int>(e);
        for (std::size_t i = 0; i < omega.size(); ++i, row += 2) {
            const Basis basis = basisAt(bank, omega[i]);
            const double w = weightAt(omega[i]);
            const Complex f = scale * curves[e].value[i];
            for (int k = 0; k < kOrder; ++k) {
                const Complex own = w * basis[static_cast<std::size_t>(k)], common = -f * own;
                M(row, first + k) = own.real();
                M(row + 1, first + k) = own.imag();
                M(row, shared + k) = common.real();
                M(row + 1, shared + k) = common.imag();
            }
            if (curves[e].direct) M(row, first + kOrder) = w;
            right(row) = w * f.real();
            right(row + 1) = w * f.imag();
        }
    }
    const Eigen::VectorXd x = M.colPivHouseholderQr().solve(right);
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(kOrder, kOrder);
    for (int k = 0; k < kOrder; k += 2) {
        const MemoryFilter& filter = bank[static_cast<std::size_t>(k / 2)];
        A(k, k + 1) = 1.0;
        A(k + 1, k) = -filter.stiffness_perS2;
        A(k + 1, k + 1) = -filter.damping_perS;
        for (int j = 0; j < kOrder; ++j) A(k + 1, j) -= x(shared + j);
    }
    return fromPoles(A.eigenvalues());
}

}  // namespace

FilterBank commonFilters(const std::vector<double>& omega, const std::vector<MemoryCurve>& curves) {
    FilterBank bank;
    for (std::size_t k = 0; k < kMemoryFilters; ++k) {
        const double w = 0.7 * std::pow(1.9, static_cast<double>(k));
        bank[k] = {w * w, 0.6 * w};
    }
    if (curves.empty()) return bank;
    for (int i = 0; i < 12; ++i) bank = relocated(bank, omega, curves);
    return bank;
}

std::array<double, 2 * kMemoryFilters + 1> onFilters(const FilterBank& bank, const std::vector<double>& omega,
                                                     const MemoryCurve& curve) {
    const int points = static_cast<int>(omega.size()), width = kOrder + (curve.direct ? 1 : 0);
    Eigen::MatrixXd M(2 * points, width);
    Eigen::VectorXd right(2 * points);
    for (int i = 0; i < points; ++i) {
        const Basis basis = basisAt(bank, omega[static_cast<std::size_t>(i)]);
        const double w = weightAt(omega[static_cast<std::size_t>(i)]);
        for (int k = 0; k < width; ++k) {
            const Complex b = k < kOrder ? basis[static_cast<std::size_t>(k)] : Complex(1.0);
            M(2 * i, k) = w * b.real();
            M(2 * i + 1, k) = w * b.imag();
        }
        right(2 * i) = w * curve.value[static_cast<std::size_t>(i)].real();
        right(2 * i + 1) = w * curve.value[static_cast<std::size_t>(i)].imag();
    }
    const Eigen::VectorXd x = M.colPivHouseholderQr().solve(right);
    std::array<double, 2 * kMemoryFilters + 1> share{};
    for (int k = 0; k < width; ++k) share[static_cast<std::size_t>(k)] = x(k);
    return share;
}

}  // namespace sagara::core
