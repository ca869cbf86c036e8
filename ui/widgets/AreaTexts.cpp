#include "ui/widgets/AreaTexts.h"

#include <QStringList>

#include "ui/chart/Format.h"

namespace sagara::ui {

QString plainName(const std::string& name) {
    const QString whole = QString::fromStdString(name);
    const QString plain = whole.left(whole.indexOf(u'(')).simplified();
    return plain.isEmpty() ? whole.simplified() : plain;
}

QString lightCharacter(const core::Light& light) { return QString::fromStdString(light.character); }

QString lightText(const core::Light& light) {
    QString text = lightCharacter(light);
    if (light.height_m > 0.0) text += QStringLiteral(" %1m").arg(chart::shortNumber(light.height_m, 0));
    if (light.range_M > 0.0) text += QStringLiteral(" %1M").arg(chart::shortNumber(light.range_M, 0));
    return text;
}

LightColour lightColour(const core::Light& light) {
    const QStringList words = lightCharacter(light).split(u' ');
    if (words.contains(QStringLiteral("R"))) return LightColour::Red;
    return words.contains(QStringLiteral("G")) ? LightColour::Green : LightColour::White;
}

bool depthsAreModelled(const core::Area& area) { return area.depthSource.starts_with("modelled"); }

}  // namespace sagara::ui
