#include "ui/settings/ControlsSection.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStackedWidget>

#include "ui/settings/AxisBar.h"
#include "ui/settings/CalibrationPanel.h"
#include "ui/settings/StoredSettings.h"
#include "ui/theme/ThemeColours.h"

namespace sagara::ui {
namespace {

/// Only seen where there is a shaft to choose, but its place is kept.
QComboBox* shaftChoice(int shaft, QWidget* parent) {
    auto* const box = new QComboBox(parent);
    QSizePolicy policy = box->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    box->setSizePolicy(policy);
    box->addItem(ControlsSection::tr("all shafts"), kEveryShaft);
    for (int i = 0; i < kMostMappedShafts; ++i) box->addItem(ControlsSection::tr("shaft %1").arg(i + 1), i);
    box->setCurrentIndex(box->findData(shaft));
    box->setToolTip(ControlsSection::tr("Shafts are counted from port; 1 is the only one of a single screw"));
    return box;
}

void lightLamp(QLabel* lamp, bool on, PaletteName palette) {
    const ThemeColours& c = themeColours(palette);
    lamp->setStyleSheet(QStringLiteral("background: %1; border: 1px solid %2; border-radius: 7px;")
                            .arg((on ? c.running : c.surface).name(), (on ? c.running : c.border).name()));
}

}  // namespace

ControlsSection::ControlsSection(SettingsStore& store, BridgeInput& input, QWidget* parent)
    : Section(tr("Joystick and wheel"), QStringLiteral("propulsion-rudder"), parent),
      m_store(store),
      m_input(input),
      m_devices(new QComboBox(this)),
      m_usual(new QPushButton(tr("Back to usual"), this)),
      m_stack(new QStackedWidget(this)) {
    m_devices->setObjectName(QStringLiteral("devices"));
    m_devices->setToolTip(tr("Devices that are plugged in. Devices of one model share what is set here."));
    m_usual->setObjectName(QStringLiteral("usual-map"));
    m_usual->setToolTip(
        tr("First axis rudder, first button horn, hat telegraph and look; calibration undone"));
    const QString& trouble = input.joysticks().trouble();
    auto* const empty =
        note(trouble.isEmpty()
                 ? tr("No joystick, wheel or gamepad is plugged in.\n\nPlug one in: it appears here at once, "
                      "with its axes and buttons moving as you move them. Until then the bridge is worked by "
                      "keyboard and mouse.")
                 : tr("Joysticks cannot be used: %1").arg(trouble));
    empty->setObjectName(QStringLiteral("no-device"));
    empty->setAlignment(Qt::AlignTop);
    empty->setMargin(8);
    m_stack->addWidget(empty);
    auto* const top = new QHBoxLayout;
    auto* const label = new QLabel(tr("&Device"), this);
    label->setBuddy(m_devices);
    top->addWidget(label);
    top->addWidget(m_devices, 1);
    top->addWidget(m_usual);
    auto* const layout = new QVBoxLayout(this);
    layout->addLayout(top);
    layout->addWidget(m_stack, 1);

    connect(m_devices, &QComboBox::activated, this, &ControlsSection::showDevice);
    connect(m_usual, &QPushButton::clicked, this, [this] {
        m_map = usualMap(m_device.axes, m_device.buttons, m_device.hats);
        keep();
        showDevice();
    });
    connect(&input.joysticks(), &Joysticks::plugged, this, &ControlsSection::listDevices);
    connect(&input.joysticks(), &Joysticks::unplugged, this, &ControlsSection::listDevices);
    listDevices();
}

void ControlsSection::listDevices() {
    const QVariant chosen = m_devices->currentData();
    {
        const QSignalBlocker quiet(m_devices);
        m_devices->clear();
        for (const JoystickInfo& device : m_input.joysticks().devices())
            m_devices->addItem(
                tr("%1 (%2 axes, %3 buttons)").arg(device.name).arg(device.axes).arg(device.allButtons()),
                device.id);
        // A box with a placeholder chooses nothing by itself.
        m_devices->setCurrentIndex(std::max(m_devices->count() > 0 ? 0 : -1, m_devices->findData(chosen)));
    }
    showDevice();
}

void ControlsSection::showDevice() {
    endCalibration();
    m_axes.clear();
    m_lamps.clear();
    m_lit.clear();
    if (m_shown != nullptr) m_stack->removeWidget(m_shown);
    delete m_shown;
    m_shown = nullptr;
    m_device = {};
    for (const JoystickInfo& device : m_input.joysticks().devices())
        if (m_devices->count() > 0 && device.id == m_devices->currentData().toInt()) m_device = device;
    const bool any = !m_device.model.empty();
    m_devices->setEnabled(any);
    m_usual->setEnabled(any);
    if (m_devices->count() == 0) m_devices->setPlaceholderText(tr("nothing plugged in"));
    if (!any) return;

    m_map = m_input.mapOf(m_device);
    auto* const axes = new QGroupBox(tr("Axes"));
    auto* const axisGrid = new QGridLayout(axes);
    const QString heads[] = {tr("Axis"),      tr("Live"),     tr("Does"), tr("Shaft"),
                             tr("Dead zone"), tr("Inverted"), {}};
    int column = 0;
    for (const QString& head : heads) axisGrid->addWidget(note(head), 0, column++);
    axisGrid->setColumnStretch(1, 1);
    for (int i = 0; i < m_device.axes; ++i) addAxis(axisGrid, i);
    auto* const buttons = new QGroupBox(tr("Buttons"));
    auto* const buttonGrid = new QGridLayout(buttons);
    for (int i = 0; i < m_device.allButtons(); ++i) addButton(buttonGrid, i);
    for (const int stretch : {2, 6}) buttonGrid->setColumnStretch(stretch, 1);
    auto* const content = new QWidget;
    auto* const layout = new QVBoxLayout(content);
    layout->setContentsMargins(0, 0, 8, 0);
    layout->addWidget(axes);
    layout->addWidget(buttons);
    layout->addStretch();
    axes->setVisible(m_device.axes > 0);
    buttons->setVisible(m_device.allButtons() > 0);
    auto* const scroll = new QScrollArea(m_stack);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidget(content);
    m_shown = scroll;
    m_stack->addWidget(scroll);
    m_stack->setCurrentWidget(scroll);
    setColours(Section::palette());
    refresh();
}

void ControlsSection::addAxis(QGridLayout* grid, int axis) {
    QWidget* const parent = grid->parentWidget();
    AxisMap& map = m_map.axes[static_cast<std::size_t>(axis)];
    const int row = axis + 1;
    auto* const bar = new AxisBar(parent);
    bar->setObjectName(QStringLiteral("axis-bar-%1").arg(axis));
    auto* const use = new QComboBox(parent);
    use->setObjectName(QStringLiteral("axis-use-%1").arg(axis));
    use->setToolTip(
        tr("What moving this axis does. Right, or pushed away from you, should be starboard, ahead "
           "and look right: else invert it."));
    for (const AxisUse each : kAxisUses) use->addItem(axisUseText(each), static_cast<int>(each));
    use->setCurrentIndex(use->findData(static_cast<int>(map.use)));
    auto* const shaft = shaftChoice(map.shaft, parent);
    shaft->setObjectName(QStringLiteral("axis-shaft-%1").arg(axis));
    shaft->setVisible(needsShaft(map.use));
    auto* const dead = new QSpinBox(parent);
    dead->setObjectName(QStringLiteral("axis-dead-%1").arg(axis));
    dead->setRange(0, static_cast<int>(100.0 * kMostDeadZone));
    dead->setSuffix(tr(" %"));
    dead->setValue(static_cast<int>(std::lround(100.0 * map.calibration.deadZone)));
    dead->setToolTip(tr("Part of the way around the middle that counts as the middle, 0 to 50 %"));
    auto* const inverted = new QCheckBox(parent);
    inverted->setObjectName(QStringLiteral("axis-inverted-%1").arg(axis));
    inverted->setChecked(map.calibration.inverted);
    inverted->setToolTip(tr("Turn the axis round"));
    auto* const start = new QPushButton(tr("Calibrate"), parent);
    start->setObjectName(QStringLiteral("calibrate-%1").arg(axis));
    start->setToolTip(tr("Find middle and ends of this axis in two steps"));
    grid->addWidget(new QLabel(QString::number(axis + 1), parent), row, 0);
    grid->addWidget(bar, row, 1);
    grid->addWidget(use, row, 2);
    grid->addWidget(shaft, row, 3);
    grid->addWidget(dead, row, 4);
    grid->addWidget(inverted, row, 5, Qt::AlignCenter);
    grid->addWidget(start, row, 6);
    m_axes.push_back({bar, use, shaft});

    const auto index = static_cast<std::size_t>(axis);
    connect(use, &QComboBox::activated, this, [this, use, shaft, index] {
        m_map.axes[index].use = static_cast<AxisUse>(use->currentData().toInt());
        shaft->setVisible(needsShaft(m_map.axes[index].use));
        keep();
    });
    connect(shaft, &QComboBox::activated, this, [this, shaft, index] {
        m_map.axes[index].shaft = shaft->currentData().toInt();
        keep();
    });
    connect(dead, &QSpinBox::valueChanged, this, [this, index](int percent) {
        m_map.axes[index].calibration.deadZone = 0.01 * percent;
        keep();
    });
    connect(inverted, &QCheckBox::toggled, this, [this, index](bool on) {
        m_map.axes[index].calibration.inverted = on;
        keep();
    });
    connect(start, &QPushButton::clicked, this, [this, axis] { calibrate(axis); });
}

QString ControlsSection::buttonName(int button) const {
    if (button < m_device.buttons) return QString::number(button + 1);
    const QString ways[] = {tr("hat up"), tr("hat right"), tr("hat down"), tr("hat left")};
    const int way = button - m_device.buttons;
    return m_device.hats > 1 ? tr("%1, %2").arg(ways[way % 4]).arg(way / 4 + 1) : ways[way % 4];
}

void ControlsSection::addButton(QGridLayout* grid, int button) {
    QWidget* const parent = grid->parentWidget();
    const auto index = static_cast<std::size_t>(button);
    const ButtonMap& map = m_map.buttons[index];
    const int half = (m_device.allButtons() + 1) / 2;  // two columns, each read downwards
    const int row = button % half;
    const int column = button < half ? 0 : 4;
    auto* const lamp = new QLabel(parent);
    lamp->setFixedSize(14, 14);
    lamp->setToolTip(tr("Lit while the button is held"));
    auto* const action = new QComboBox(parent);
    action->setObjectName(QStringLiteral("button-action-%1").arg(button));
    action->setToolTip(tr("What pressing this button does"));
    for (int i = 0; i < kBridgeActions; ++i) action->addItem(actionText(static_cast<BridgeAction>(i)), i);
    action->setCurrentIndex(action->findData(static_cast<int>(map.action)));
    auto* const shaft = shaftChoice(map.shaft, parent);
    shaft->setVisible(needsShaft(map.action));
    grid->addWidget(lamp, row, column);
    grid->addWidget(new QLabel(buttonName(button), parent), row, column + 1);
    grid->addWidget(action, row, column + 2);
    grid->addWidget(shaft, row, column + 3);
    m_lamps.push_back(lamp);
    m_lit.push_back(false);
    connect(action, &QComboBox::activated, this, [this, action, shaft, index] {
        m_map.buttons[index].action = static_cast<BridgeAction>(action->currentData().toInt());
        shaft->setVisible(needsShaft(m_map.buttons[index].action));
        keep();
    });
    connect(shaft, &QComboBox::activated, this, [this, shaft, index] {
        m_map.buttons[index].shaft = shaft->currentData().toInt();
        keep();
    });
}

void ControlsSection::keep() {
    m_input.setMap(m_device.model, m_map);
    storeMap(m_store, m_device.model, m_map);
}

void ControlsSection::calibrate(int axis) {
    endCalibration();
    const auto index = static_cast<std::size_t>(axis);
    m_calibration =
        new CalibrationPanel(axis, tr("axis %1").arg(axis + 1), m_map.axes[index].calibration, this);
    m_calibration->setColours(Section::palette());
    static_cast<QVBoxLayout*>(layout())->insertWidget(1, m_calibration);
    connect(m_calibration, &CalibrationPanel::cancelled, this, &ControlsSection::endCalibration);
    connect(m_calibration, &CalibrationPanel::found, this, [this, index](const AxisCalibration& found) {
        m_map.axes[index].calibration = found;
        keep();
        endCalibration();
    });
}

void ControlsSection::endCalibration() {
    if (m_calibration == nullptr) return;
    m_calibration->hide();
    m_calibration->deleteLater();  // it may be asking for it itself
    m_calibration = nullptr;
}

void ControlsSection::setColours(PaletteName palette) {
    Section::setColours(palette);
    for (const AxisRow& row : m_axes) row.bar->setColours(palette);
    for (std::size_t i = 0; i < m_lamps.size(); ++i) lightLamp(m_lamps[i], m_lit[i], palette);
    if (m_calibration != nullptr) m_calibration->setColours(palette);
}

void ControlsSection::refresh() {
    const Joysticks& sticks = m_input.joysticks();
    for (std::size_t i = 0; i < m_axes.size(); ++i)
        m_axes[i].bar->show(m_map.axes[i].calibration, sticks.axis(m_device.id, static_cast<int>(i)));
    for (std::size_t i = 0; i < m_lamps.size(); ++i) {
        const bool down = sticks.button(m_device.id, static_cast<int>(i));
        if (down == m_lit[i]) continue;
        m_lit[i] = down;
        lightLamp(m_lamps[i], down, Section::palette());
    }
    if (m_calibration != nullptr) m_calibration->feed(sticks.axis(m_device.id, m_calibration->axis()));
}

}  // namespace sagara::ui
