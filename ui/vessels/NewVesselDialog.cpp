#include "ui/vessels/NewVesselDialog.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSpinBox>
#include <QTimer>
#include <QVBoxLayout>
#include <cmath>

#include "core/base/Units.h"
#include "core/vessel/Vessel.h"
#include "ui/theme/ThemeColours.h"
#include "ui/vessels/WrongWords.h"

namespace sagara::ui {
namespace {

QString idOf(const QString& name) {
    QString id;
    for (const QChar c : name.toLower()) {
        if ((c >= QLatin1Char('a') && c <= QLatin1Char('z')) || c.isDigit())
            id += c;
        else if (!id.isEmpty() && !id.endsWith(QLatin1Char('-')))
            id += QLatin1Char('-');
    }
    while (id.endsWith(QLatin1Char('-'))) id.chop(1);
    return id.left(60);
}

}  // namespace

NewVesselDialog::NewVesselDialog(PaletteName colours, Taken taken, Save save, QWidget* parent)
    : QDialog(parent),
      m_colours(colours),
      m_taken(std::move(taken)),
      m_save(std::move(save)),
      m_id(new QLineEdit(this)),
      m_name(new QLineEdit(this)),
      m_kind(new QComboBox(this)),
      m_fullness(new QComboBox(this)),
      m_shafts(new QSpinBox(this)),
      m_rudders(new QSpinBox(this)),
      m_summary(new QLabel(this)),
      m_ok(new QPushButton(tr("Create vessel"), this)),
      m_timer(new QTimer(this)) {
    setWindowTitle(tr("New vessel from particulars"));
    setObjectName(QStringLiteral("newVessel"));
    m_name->setObjectName(QStringLiteral("name"));
    m_id->setObjectName(QStringLiteral("id"));
    m_kind->setObjectName(QStringLiteral("kind"));
    for (const core::ShipKind& kind : core::kShipKinds) m_kind->addItem(QString::fromLatin1(kind.name));
    m_kind->setCurrentText(QStringLiteral("general cargo"));
    m_name->setPlaceholderText(tr("such as MV Ruhuna, 84 m coaster"));
    m_name->setToolTip(tr("What people choose her by"));
    m_id->setToolTip(tr("Small letters, digits and '-': how scenarios name her"));
    m_kind->setToolTip(tr("Chooses what is usual for depth, superstructure, rudder, windage"));

    auto* const left = new QFormLayout;
    addRow(left, "name", tr("Name"), m_name);
    addRow(left, "id", tr("Id"), m_id);
    addRow(left, "kind", tr("Ship type"), m_kind);
    m_loa =
        number(left, "lengthOverall_m", tr("Length overall"), 8, 420, 88, 1, tr("m"), tr("Over all, metres"));
    m_lpp = number(left, "lengthBp_m", tr("Length between perpendiculars"), 7, 400, 84, 1, tr("m"),
                   tr("Between perpendiculars, metres"));
    m_beam = number(left, "beam_m", tr("Beam"), 2, 75, 14, 2, tr("m"), tr("Moulded, metres"));
    m_draught = number(left, "draught_m", tr("Draught"), 0.5, 26, 5.4, 2, tr("m"),
                       tr("Mean draught she sails at, metres"));

    m_depth = number(left, "depth_m", tr("Depth"), 0, 60, 0, 2, tr("m"),
                     tr("Keel to main deck, metres; 0: not known, usual for the type"));
    m_depth->setSpecialValueText(tr("not known"));
    m_stability = number(left, "metacentricHeight_m", tr("Metacentric height"), 0, 30, 0, 2, tr("m"),
                         tr("GM as she is loaded, metres; 0: not known, estimated from the form"));
    m_stability->setSpecialValueText(tr("not known"));

    auto* const right = new QFormLayout;
    m_fullness->addItems({tr("Displacement"), tr("Block coefficient")});
    m_fullness->setCurrentIndex(1);
    m_fullness->setObjectName(QStringLiteral("fullness"));
    m_fullness->setToolTip(tr("Which of the two is known"));
    right->addRow(tr("Fullness given as"), m_fullness);
    m_volume = number(right, "displacement_m3", tr("Displacement"), 1, 1e6, 4800, 0, tr("m³"),
                      tr("Volume, cubic metres: tonnes over 1.025 in sea water"));
    m_block = number(right, "blockCoefficient", tr("Block coefficient"), 0.30, 0.90, 0.76, 3, QString(),
                     tr("Volume over Lpp by beam by draught"));
    m_speed = number(right, "speed_mps", tr("Service speed"), 4, 48, 12.5, 1, tr("kn"),
                     tr("Knots, at 85 % of the engine power"));
    m_power =
        number(right, "power_W", tr("Engine power"), 0, 120000, 2200, 0, tr("kW"),
               tr("Of all engines together, kilowatts, maximum continuous; 0: not known, estimated from "
                  "the resistance"));
    m_power->setSpecialValueText(tr("not known"));
    m_shafts->setRange(1, 4);
    m_shafts->setObjectName(QStringLiteral("shafts"));
    m_shafts->setToolTip(tr("Propeller shafts"));
    addRow(right, "shafts", tr("Shafts"), m_shafts);
    m_rudders->setRange(1, 4);
    m_rudders->setObjectName(QStringLiteral("rudders"));
    m_rudders->setToolTip(tr("As many as shafts: one behind each propeller"));
    addRow(right, "rudders", tr("Rudders"), m_rudders);
    m_rudderArea = number(right, "rudderArea_m2", tr("Rudder area"), 0, 300, 0, 1, tr("m²"),
                          tr("Of all rudders together, square metres; 0: not known, usual for the type"));
    m_rudderArea->setSpecialValueText(tr("not known"));
    m_propeller = number(right, "propellerDiameter_m", tr("Propeller diameter"), 0, 12, 0, 2, tr("m"),
                         tr("Metres; 0: not known, estimated from the draught"));
    m_propeller->setSpecialValueText(tr("not known"));
    m_thruster = number(right, "bowThruster_W", tr("Bow thruster"), 0, 5000, 0, 0, tr("kW"),
                        tr("Kilowatts of a tunnel thruster at the bow; 0: she has none"));
    m_thruster->setSpecialValueText(tr("none"));

    auto* const columns = new QHBoxLayout;
    columns->addLayout(left, 1);
    columns->addSpacing(16);
    columns->addLayout(right, 1);
    auto* const box = new QGroupBox(tr("What comes of it"), this);
    auto* const inside = new QVBoxLayout(box);
    m_summary->setWordWrap(true);
    m_summary->setMinimumHeight(72);
    m_summary->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_summary->setObjectName(QStringLiteral("summary"));
    inside->addWidget(m_summary);
    auto* const cancel = new QPushButton(tr("Cancel"), this);
    m_ok->setObjectName(QStringLiteral("create"));
    m_ok->setProperty("primary", true);
    m_ok->setDefault(true);
    m_ok->setToolTip(tr("Saves a whole vessel document, every group marked as estimated"));
    auto* const buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(cancel);
    buttons->addWidget(m_ok);
    auto* const layout = new QVBoxLayout(this);
    layout->addLayout(columns);
    layout->addWidget(box);
    layout->addStretch(1);
    layout->addLayout(buttons);
    resize(860, 540);

    m_timer->setSingleShot(true);
    m_timer->setInterval(120);
    connect(m_timer, &QTimer::timeout, this, &NewVesselDialog::check);
    const auto later = [this] { m_timer->start(); };
    for (QDoubleSpinBox* spin : {m_loa, m_lpp, m_beam, m_draught, m_depth, m_stability, m_volume, m_block,
                                 m_speed, m_power, m_rudderArea, m_propeller, m_thruster})
        connect(spin, &QDoubleSpinBox::valueChanged, this, later);
    for (QSpinBox* spin : {m_shafts, m_rudders}) connect(spin, &QSpinBox::valueChanged, this, later);
    connect(m_kind, &QComboBox::currentTextChanged, this, later);
    connect(m_id, &QLineEdit::textChanged, this, later);
    connect(m_id, &QLineEdit::textEdited, this, [this](const QString& text) { m_idTyped = !text.isEmpty(); });
    connect(m_name, &QLineEdit::textChanged, this, [this, later](const QString& name) {
        if (!m_idTyped) m_id->setText(idOf(name));
        later();
    });
    connect(m_fullness, &QComboBox::currentIndexChanged, this, [this, later](int index) {
        m_volume->setEnabled(index == 0);
        m_block->setEnabled(index == 1);
        later();
    });
    m_volume->setEnabled(false);
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_ok, &QPushButton::clicked, this, &NewVesselDialog::accept);
    check();
}

void NewVesselDialog::addRow(QFormLayout* form, const char* field, const QString& label, QWidget* widget) {
    auto* const stack = new QVBoxLayout;
    stack->setSpacing(1);
    auto* const note = new QLabel(this);
    note->setObjectName(QStringLiteral("note-") + QString::fromLatin1(field));
    note->setWordWrap(true);
    QFont small = note->font();
    small.setPointSizeF(0.9 * small.pointSizeF());
    note->setFont(small);
    QPalette colours = note->palette();
    colours.setColor(QPalette::WindowText, wrongWords(m_colours));
    note->setPalette(colours);
    note->hide();
    stack->addWidget(widget);
    stack->addWidget(note);
    form->addRow(label, stack);
    m_notes[field] = note;
}

QDoubleSpinBox* NewVesselDialog::number(QFormLayout* form, const char* field, const QString& label,
                                        double low, double high, double value, int decimals,
                                        const QString& unit, const QString& tip) {
    auto* const spin = new QDoubleSpinBox(this);
    spin->setObjectName(QString::fromLatin1(field));
    spin->setRange(low, high);
    spin->setDecimals(decimals);
    spin->setValue(value);
    if (!unit.isEmpty()) spin->setSuffix(QLatin1Char(' ') + unit);
    spin->setToolTip(tip + tr(" (%1 to %2)").arg(low).arg(high));
    addRow(form, field, label, spin);
    return spin;
}

core::Particulars NewVesselDialog::particulars() const {
    core::Particulars p;
    p.id = m_id->text().trimmed().toStdString();
    p.name = m_name->text().trimmed().toStdString();
    p.kind = m_kind->currentText().toStdString();
    p.lengthOverall_m = m_loa->value();
    p.lengthBp_m = m_lpp->value();
    p.beam_m = m_beam->value();
    p.draught_m = m_draught->value();
    if (m_fullness->currentIndex() == 0)
        p.displacement_m3 = m_volume->value();
    else
        p.blockCoefficient = m_block->value();
    p.speed_mps = m_speed->value() * core::kKnot_mps;
    if (m_power->value() > 0.0) p.power_W = 1000.0 * m_power->value();
    p.shafts = m_shafts->value();
    p.rudders = m_rudders->value();
    const auto known = [](const QDoubleSpinBox* spin, std::optional<double>& member) {
        if (spin->value() > 0.0) member = spin->value();
    };
    known(m_depth, p.depth_m);
    known(m_stability, p.metacentricHeight_m);
    known(m_rudderArea, p.rudderArea_m2);
    known(m_propeller, p.propellerDiameter_m);
    if (m_thruster->value() > 0.0) p.bowThruster_W = 1e3 * m_thruster->value();
    return p;
}

void NewVesselDialog::check() {
    m_timer->stop();
    for (const auto& [field, note] : m_notes) note->hide();
    const core::Particulars p = particulars();
    const auto document = core::vesselFromParticulars(p);
    m_text = document ? *document : std::string();
    const auto say = [&](const std::string& field, const QString& what) {
        const auto it = m_notes.find(field);
        if (it == m_notes.end()) return;
        it->second->setText(what);
        it->second->show();
    };
    if (!document) {
        for (const core::config::Problem& problem : document.error().list()) {
            QString expected = QString::fromStdString(problem.expected);
            if (problem.path == "name" && p.name.empty())
                expected = tr("Enter the name people choose her by");
            else if (problem.path == "id" && p.id.empty())
                expected = tr("Small letters, digits and '-'");
            else
                expected = tr("Accepted: %1").arg(expected);
            say(problem.path, expected);
        }
    } else if (m_taken(p.id)) {
        say("id", tr("There is a vessel of this id already. Choose another."));
        m_text.clear();
    }
    m_ok->setEnabled(!m_text.empty());
    m_summary->setText(
        m_text.empty() ? tr("Mend the fields marked above; then the ship that comes of them is told here.")
                       : summary());
}

QString NewVesselDialog::summary() const {
    const auto vessel = core::loadVessel("new", m_text);
    if (!vessel) return {};
    const core::Vessel& v = *vessel;
    const core::Particulars p = particulars();
    const QString power = p.power_W
                              ? QString()
                              : tr("Engine power about %1 kW, by resistance. ")
                                    .arg(10.0 * std::round(1e-4 * core::powerForResistance_W(p)), 0, 'f', 0);
    return tr("%1 t, block coefficient %2. GM %3 m. Propellers: %4")
               .arg(v.hull.mass_kg() / 1000.0, 0, 'f', 0)
               .arg(v.hull.blockCoefficient(), 0, 'f', 3)
               .arg(v.hull.metacentricHeight_m, 0, 'f', 2)
               .arg(v.propulsion.units.size()) +
           tr(" of %1 m, %2 rpm at full ahead. Rudder area %3 m². Depth %4 m, side wind area %5 m². ")
               .arg(v.propulsion.units[0].diameter_m, 0, 'f', 2)
               .arg(v.propulsion.telegraph_rps.back() / core::kRpm_rps, 0, 'f', 0)
               .arg(v.steering.areaEach_m2 * static_cast<double>(v.steering.rudders.size()), 0, 'f', 1)
               .arg(v.hull.depth_m, 0, 'f', 1)
               .arg(v.windage.lateralArea_m2, 0, 'f', 0) +
           power +
           tr("Estimated by published regressions: expect 20 to 30 % in turning. Test her before a lesson, "
              "and "
              "replace what you know better.");
}

void NewVesselDialog::accept() {
    check();
    if (m_text.empty()) return;
    const core::Particulars p = particulars();
    if (const auto trouble = m_save(p.id, p.name, m_text)) {
        QMessageBox::warning(this, windowTitle(), QString::fromStdString(*trouble));
        return;
    }
    QDialog::accept();
}

}  // namespace sagara::ui
