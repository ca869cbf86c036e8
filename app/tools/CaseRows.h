#pragma once

#include "app/tools/ValidationCase.h"

namespace sagara::tools {

/// Relative errors of many numbers, gathered: the largest and the root of the mean of squares.
class RelativeErrors {
public:
    /// Relative to `least` where the reference is less than that.
    void add(double found, double reference, double least = 0.0);

    // Not numbers where nothing was added, so that a case without points falls short.
    double largest() const;
    double rms() const;

private:
    double m_largest = 0.0;
    double m_squares = 0.0;
    int m_count = 0;
};

/// "KT, largest error, %" of a quantity "KT". The tolerance as a share.
ValidationRow largestErrorRow(const std::string& quantity, const RelativeErrors& errors, double tolerance);
ValidationRow rmsErrorRow(const std::string& quantity, const RelativeErrors& errors, double tolerance);

/// A share that is allowed as error, of a case's document: 1e-7 to 1.
double readShare(core::config::Reader& in, std::string_view key);

}  // namespace sagara::tools
