#include "ui/report/Remarks.h"

#include <cmath>

#include "ui/report/Format.h"
#include "ui/report/Text.h"

namespace sagara::report {
namespace {

/// The point of a series that `better` prefers, nothing when it has no finite one.
template <typename Better>
const QPointF* extreme(const PlotSeries& series, Better&& better) {
    const QPointF* best = nullptr;
    for (const QPointF& p : series.points) {
        if (std::isfinite(p.y()) && (!best || better(p.y(), best->y()))) best = &p;
    }
    return best;
}

bool fartherFromZero(double a, double b) { return std::abs(a) > std::abs(b); }

}  // namespace

const QPointF* lowest(const PlotSeries& series) {
    return extreme(series, [](double a, double b) { return a < b; });
}

const QPointF* highest(const PlotSeries& series) {
    return extreme(series, [](double a, double b) { return a > b; });
}

QString remark(const QString& word, const QPointF* p, int decimals) {
    if (!p) return {};
    return tr("%1 %2 at %3").arg(word, number(p->y(), decimals), clockTime(p->x()));
}

QString sidedRemark(const PlotSeries& series, int decimals) {
    const QPointF* p = extreme(series, fartherFromZero);
    if (!p || number(p->y(), decimals) == number(0.0, decimals)) return {};
    const QString side = p->y() < 0.0 ? tr("to port") : tr("to starboard");
    return tr("most %1 %2 at %3").arg(number(std::abs(p->y()), decimals), side, clockTime(p->x()));
}

}  // namespace sagara::report
