#include "ui/editor/FieldText.h"

#include <QLocale>
#include <QRegularExpression>
#include <cmath>

#include "core/base/Config.h"
#include "ui/chart/Format.h"

namespace sagara::ui::editor {
namespace {

QString plain(const Json& value) {
    if (value.is_string()) return QString::fromStdString(value.get<std::string>());
    if (value.is_number_integer()) return QString::number(value.get<std::int64_t>());
    if (value.is_number()) return QString::fromStdString(core::config::formatNumber(value.get<double>()));
    return QString::fromStdString(value.dump());
}

std::optional<Json> typedNumber(QString text, bool whole) {
    text = text.trimmed().replace(u',', u'.');
    bool good = false;
    const qlonglong integer = QLocale::c().toLongLong(text, &good);
    if (good) return Json(integer);
    const double value = QLocale::c().toDouble(text, &good);
    if (!good || whole || !std::isfinite(value)) return std::nullopt;
    return Json(value);
}

/// Degrees and minutes with a letter; degrees may have decimals when there are no minutes.
std::optional<double> degreesOf(const QRegularExpressionMatch& m, int first, QChar negative, double most) {
    const double minutes = m.captured(first + 1).isEmpty() ? 0.0 : m.captured(first + 1).toDouble();
    const double degrees = m.captured(first).toDouble() + minutes / 60.0;
    if (minutes >= 60.0 || degrees > most) return std::nullopt;
    return m.captured(first + 2).toUpper() == negative ? -degrees : degrees;
}

QString inWords(const Field& field, const Json& value) {
    if (field.kind == FieldKind::List) {
        QStringList rows;
        for (const Json& row : value) rows << rowInWords(*field.list, row);
        return rows.join(QStringLiteral("; "));
    }
    if (value.is_array()) {
        QStringList all;
        for (const Json& item : value) {
            const auto place = positionOf(&item);
            all << (place ? positionText(*place) : plain(item));
        }
        return all.join(QStringLiteral(", "));
    }
    if (field.kind == FieldKind::Flag) return {};
    const QString text = shown(field, &value);
    return field.unit.isEmpty() ? text : QStringLiteral("%1 %2").arg(text, field.unit);
}

}  // namespace

QString positionText(core::GeoPoint place) {
    return chart::latitude(place.lat_deg, 4) + QLatin1Char(' ') + chart::longitude(place.lon_deg, 4);
}

std::optional<core::GeoPoint> typedPosition(const QString& text) {
    static const QRegularExpression decimal(
        QStringLiteral(R"(^\s*(-?\d+(?:\.\d+)?)°?\s*[,;\s]\s*(-?\d+(?:\.\d+)?)°?\s*$)"));
    if (const auto m = decimal.match(text); m.hasMatch()) {
        const core::GeoPoint place{m.captured(1).toDouble(), m.captured(2).toDouble()};
        if (std::abs(place.lat_deg) > 90.0 || std::abs(place.lon_deg) > 180.0) return std::nullopt;
        return place;
    }
    static const QRegularExpression minutes(
        QStringLiteral(R"(^\s*(\d+(?:\.\d+)?)[°\s]*(\d+(?:\.\d+)?)?\s*['′]?\s*([NSns])[,;\s]*)"
                       R"((\d+(?:\.\d+)?)[°\s]*(\d+(?:\.\d+)?)?\s*['′]?\s*([EWew])\s*$)"));
    const auto m = minutes.match(text);
    if (!m.hasMatch()) return std::nullopt;
    const auto lat_deg = degreesOf(m, 1, u'S', 90.0), lon_deg = degreesOf(m, 4, u'W', 180.0);
    if (!lat_deg || !lon_deg) return std::nullopt;
    return core::GeoPoint{*lat_deg, *lon_deg};
}

Json positionJson(core::GeoPoint place) {
    const auto rounded = [](double degrees) { return std::round(degrees * 1e7) / 1e7; };  // 1 cm
    return Json{{"lat", rounded(place.lat_deg)}, {"lon", rounded(place.lon_deg)}};
}

std::optional<core::GeoPoint> positionOf(const Json* value) {
    if (!value || !value->is_object()) return std::nullopt;
    const double lat_deg = numberAt(*value, "lat", std::nan("")),
                 lon_deg = numberAt(*value, "lon", std::nan(""));
    if (!std::isfinite(lat_deg) || !std::isfinite(lon_deg)) return std::nullopt;
    return core::GeoPoint{lat_deg, lon_deg};
}

QString shown(const Field& field, const Json* value) {
    if (!value || value->is_null()) return {};
    if (field.kind == FieldKind::Position || field.kind == FieldKind::Place) {
        const auto place = positionOf(value);
        return place ? positionText(*place) : plain(*value);
    }
    if (field.kind == FieldKind::Flag)
        return value->is_boolean() && value->get<bool>() ? QStringLiteral("✓") : QString();
    for (const Option& option : field.options)
        if (value->is_string() && option.value == value->get_ref<const std::string&>()) return option.label;
    return plain(*value);
}

std::optional<Json> typed(const Field& field, const QString& text) {
    switch (field.kind) {
        case FieldKind::Number:
        case FieldKind::Integer:
            return typedNumber(text, field.kind == FieldKind::Integer);
        case FieldKind::Position: {
            const auto place = typedPosition(text);
            return place ? std::optional(positionJson(*place)) : std::nullopt;
        }
        case FieldKind::Id:
            if (!core::config::isId(text.toStdString())) return std::nullopt;
            return Json(text.toStdString());
        default:
            return Json(text.toStdString());
    }
}

QString accepted(const Field& field) {
    switch (field.kind) {
        case FieldKind::Number:
        case FieldKind::Numbers:
            return words("%1 to %2 %3")
                .arg(chart::shortNumber(field.low, 3), chart::shortNumber(field.high, 3), field.unit)
                .trimmed();
        case FieldKind::Integer:
            return words("a whole number from %1 to %2").arg(field.low).arg(field.high);
        case FieldKind::Id:
            return words("1 to 60 letters a-z, digits and hyphens");
        case FieldKind::Position:
            return words("006°01.95'N 080°13.60'E, or 6.0325, 80.2267");
        default:
            return {};
    }
}

QString rowInWords(const ListSpec& spec, const Json& row) {
    QStringList parts;
    for (const Field& f : spec.fieldsOf(row)) {
        const Json* value = find(row, f.key);
        if (!value || f.key == "id" || f.key == "title" || f.key == "name") continue;
        if (f.kind == FieldKind::Flag) {
            if (value->is_boolean() && value->get<bool>()) parts << f.label;
            continue;
        }
        if (value->is_array() && value->empty()) continue;
        const QString said = inWords(f, *value);
        parts << (f.kind == FieldKind::List ? said : QStringLiteral("%1 %2").arg(f.label.toLower(), said));
    }
    const Variant* variant = spec.variantOf(row);
    if (variant && !spec.kindKey.empty() && spec.columns.front() == spec.kindKey && parts.isEmpty())
        return variant->label;
    return parts.join(QStringLiteral(", "));
}

}  // namespace sagara::ui::editor
