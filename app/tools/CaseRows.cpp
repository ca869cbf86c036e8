#include "app/tools/CaseRows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sagara::tools {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

ValidationRow percentRow(std::string quantity, double error, double tolerance) {
    ValidationRow row;
    row.quantity = std::move(quantity);
    row.measured = 100.0 * error;
    row.tolerance = 100.0 * tolerance;
    return row;
}

}  // namespace

void RelativeErrors::add(double found, double reference, double least) {
    const double error = (found - reference) / std::max(std::abs(reference), least);
    m_largest = std::isfinite(error) ? std::max(m_largest, std::abs(error)) : kNone;
    m_squares += error * error;
    ++m_count;
}

double RelativeErrors::largest() const { return m_count > 0 && std::isfinite(m_squares) ? m_largest : kNone; }
double RelativeErrors::rms() const { return m_count > 0 ? std::sqrt(m_squares / m_count) : kNone; }

ValidationRow largestErrorRow(const std::string& quantity, const RelativeErrors& errors, double tolerance) {
    return percentRow(quantity + ", largest error, %", errors.largest(), tolerance);
}

ValidationRow rmsErrorRow(const std::string& quantity, const RelativeErrors& errors, double tolerance) {
    return percentRow(quantity + ", rms error, %", errors.rms(), tolerance);
}

double readShare(core::config::Reader& in, std::string_view key) { return in.number(key, {1e-7, 1.0, ""}); }

}  // namespace sagara::tools
