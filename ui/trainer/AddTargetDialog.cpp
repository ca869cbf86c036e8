#include "ui/trainer/AddTargetDialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <array>

#include "core/base/Units.h"

namespace sagara::ui {
namespace {

using core::TargetType;

/// A usual ship of each kind.
struct Usual {
    TargetType type;
    const char* name;
    double length_m, beam_m, draught_m, speed_kn;
};
constexpr std::array<Usual, 8> kUsual{
    {{TargetType::Fishing, QT_TRANSLATE_NOOP("sagara::ui::AddTargetDialog", "Fishing boat"), 14.0, 4.5, 1.6,
      7.0},
     {TargetType::Coaster, QT_TRANSLATE_NOOP("sagara::ui::AddTargetDialog", "Coaster"), 88.0, 13.5, 5.5,
      11.0},
     {TargetType::Tanker, QT_TRANSLATE_NOOP("sagara::ui::AddTargetDialog", "Tanker"), 183.0, 32.0, 11.0,
      13.0},
     {TargetType::Container, QT_TRANSLATE_NOOP("sagara::ui::AddTargetDialog", "Container ship"), 260.0, 32.2,
      12.0, 18.0},
     {TargetType::Ferry, QT_TRANSLATE_NOOP("sagara::ui::AddTargetDialog", "Ferry"), 60.0, 12.0, 3.0, 14.0},
     {TargetType::Yacht, QT_TRANSLATE_NOOP("sagara::ui::AddTargetDialog", "Sailing yacht"), 12.0, 3.8, 2.0,
      5.0},
     {TargetType::Tug, QT_TRANSLATE_NOOP("sagara::ui::AddTargetDialog", "Tug"), 28.0, 9.5, 4.0, 9.0},
     {TargetType::FastCraft, QT_TRANSLATE_NOOP("sagara::ui::AddTargetDialog", "Fast craft"), 9.0, 2.8, 0.7,
      25.0}}};

QDoubleSpinBox* spin(double least, double most, double value, int decimals, const QString& unit,
                     const QString& name, QWidget* parent) {
    auto* const spin = new QDoubleSpinBox(parent);
    spin->setObjectName(name);
    spin->setRange(least, most);
    spin->setDecimals(decimals);
    spin->setValue(value);
    spin->setSuffix(QLatin1Char(' ') + unit);
    spin->setToolTip(AddTargetDialog::tr("%1 to %2 %3").arg(least).arg(most).arg(unit));
    return spin;
}

}  // namespace

AddTargetDialog::AddTargetDialog(const QString& place, std::size_t number, QWidget* parent)
    : QDialog(parent),
      m_name(new QLineEdit(tr("Ship %1").arg(number), this)),
      m_type(new QComboBox(this)),
      m_activity(new QComboBox(this)),
      m_hostile(new QCheckBox(tr("A threat: closes the own ship and harasses her"), this)),
      m_heading(spin(0.0, 359.9, 0.0, 1, tr("°T"), QStringLiteral("add-heading"), this)),
      m_speed(spin(0.0, 60.0, 7.0, 1, tr("kn"), QStringLiteral("add-speed"), this)),
      m_length(spin(3.0, 400.0, 14.0, 1, tr("m"), QStringLiteral("add-length"), this)),
      m_beam(spin(1.0, 70.0, 4.5, 1, tr("m"), QStringLiteral("add-beam"), this)),
      m_draught(spin(0.2, 25.0, 1.6, 1, tr("m"), QStringLiteral("add-draught"), this)) {
    setObjectName(QStringLiteral("add-target-dialog"));
    setWindowTitle(tr("Add a ship"));
    m_name->setObjectName(QStringLiteral("add-name"));
    m_name->setMaxLength(30);
    m_name->setToolTip(tr("1 to 30 letters"));
    m_type->setObjectName(QStringLiteral("add-type"));
    m_type->setToolTip(tr("How she looks and turns; her usual size goes with it"));
    for (const Usual& usual : kUsual) m_type->addItem(tr(usual.name));
    m_activity->setObjectName(QStringLiteral("add-activity"));
    m_activity->setToolTip(tr("Her lights and shapes"));
    const std::pair<QString, core::Activity> kinds[] = {
        {tr("Under way"), core::Activity::UnderWay},
        {tr("Fishing"), core::Activity::Fishing},
        {tr("Trawling"), core::Activity::Trawling},
        {tr("Towing"), core::Activity::Towing},
        {tr("Sailing"), core::Activity::Sailing},
        {tr("Not under command"), core::Activity::NotUnderCommand},
        {tr("Restricted in her ability to manoeuvre"), core::Activity::Restricted},
        {tr("At anchor"), core::Activity::Anchored}};
    for (const auto& [name, kind] : kinds) m_activity->addItem(name, static_cast<int>(kind));
    m_hostile->setObjectName(QStringLiteral("add-hostile"));
    m_hostile->setToolTip(
        tr("She waits here and comes when the own ship is within 1 M; the speed is her fastest"));
    m_heading->setWrapping(true);

    auto* const form = new QFormLayout(this);
    form->addRow(new QLabel(place, this));
    form->addRow(tr("Name"), m_name);
    form->addRow(tr("Kind"), m_type);
    form->addRow(tr("Doing"), m_activity);
    form->addRow(tr("Heading"), m_heading);
    form->addRow(tr("Speed"), m_speed);
    form->addRow(tr("Length"), m_length);
    form->addRow(tr("Beam"), m_beam);
    form->addRow(tr("Draught"), m_draught);
    form->addRow(m_hostile);
    auto* const note =
        new QLabel(tr("She keeps this course until you order another; with no speed she anchors."), this);
    note->setWordWrap(true);
    form->addRow(note);
    auto* const buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    m_ok = buttons->addButton(tr("Add"), QDialogButtonBox::AcceptRole);
    m_ok->setObjectName(QStringLiteral("add-ok"));
    m_ok->setProperty("primary", true);
    m_ok->setDefault(true);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_type, &QComboBox::currentIndexChanged, this, &AddTargetDialog::takeSizes);
    connect(m_name, &QLineEdit::textChanged, this, &AddTargetDialog::check);
}

void AddTargetDialog::takeSizes() {
    const Usual& usual = kUsual[static_cast<std::size_t>(std::max(0, m_type->currentIndex()))];
    m_length->setValue(usual.length_m);
    m_beam->setValue(usual.beam_m);
    m_draught->setValue(usual.draught_m);
    m_speed->setValue(usual.speed_kn);
    const auto doing = usual.type == TargetType::Yacht ? core::Activity::Sailing : core::Activity::UnderWay;
    m_activity->setCurrentIndex(m_activity->findData(static_cast<int>(doing)));
}

void AddTargetDialog::check() { m_ok->setEnabled(!m_name->text().simplified().isEmpty()); }

core::AddTargetOrder AddTargetDialog::order(core::NorthEast position, double trueToGrid_rad) const {
    core::AddTargetOrder order;
    order.name = m_name->text().simplified().toStdString();
    if (order.name.size() > 60) order.name.resize(60);
    order.type = kUsual[static_cast<std::size_t>(std::max(0, m_type->currentIndex()))].type;
    order.activity = static_cast<core::Activity>(m_activity->currentData().toInt());
    order.hostile = m_hostile->isChecked();
    order.position = position;
    order.heading_rad = m_heading->value() * core::kDegree_rad + trueToGrid_rad;
    order.speed_mps = m_speed->value() * core::kKnot_mps;
    order.length_m = m_length->value();
    order.beam_m = m_beam->value();
    order.draught_m = m_draught->value();
    return order;
}

}  // namespace sagara::ui
