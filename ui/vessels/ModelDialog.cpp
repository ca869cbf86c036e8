#include "ui/vessels/ModelDialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QGridLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollArea>
#include <QTimer>
#include <QVBoxLayout>
#include <nlohmann/json.hpp>

#include "ui/vessels/VesselFile.h"

namespace sagara::ui {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 6> kAxes{"+x", "-x", "+y", "-y", "+z", "-z"};
constexpr std::array<const char*, core::kLightPlaces> kLightKinds{
    "masthead-forward", "masthead-aft", "port", "starboard", "stern", "anchor-forward", "anchor-aft"};

double numberIn(const Json& object, const char* key, double fallback) {
    return object.contains(key) && object[key].is_number() ? object[key].get<double>() : fallback;
}
std::string wordIn(const Json& object, const char* key, const char* fallback) {
    return object.contains(key) && object[key].is_string() ? object[key].get<std::string>() : fallback;
}

}  // namespace

ModelDialog::ModelDialog(const std::string& text, std::filesystem::path ownModels, PaletteName,
                         StageFor stageFor, Save save, QWidget* parent)
    : QDialog(parent),
      m_text(text),
      m_ownModels(std::move(ownModels)),
      m_save(std::move(save)),
      m_view(new ShipView(std::move(stageFor), this)),
      m_file(new QLabel(this)),
      m_note(new QLabel(this)),
      m_forward(new QComboBox(this)),
      m_up(new QComboBox(this)),
      m_fit(new QComboBox(this)),
      m_scale(new QDoubleSpinBox(this)),
      m_waterline(
          metres(-1000, 1000, tr("Height of the waterline along the model's up axis, metres of the model"))),
      m_midship(
          metres(-10000, 10000, tr("Place of midship along the model's forward axis, metres of the model"))),
      m_middle(new QCheckBox(tr("midship is the middle of its length"), this)),
      m_night(new QCheckBox(tr("By night, to see the lights"), this)),
      m_licence(new QLineEdit(this)),
      m_source(new QLineEdit(this)),
      m_ok(new QPushButton(tr("Save"), this)),
      m_timer(new QTimer(this)) {
    setWindowTitle(tr("3D model of the vessel"));
    setObjectName(QStringLiteral("modelDialog"));
    resize(1120, 640);
    for (const char* axis : kAxes) {
        m_forward->addItem(QString::fromLatin1(axis));
        m_up->addItem(QString::fromLatin1(axis));
    }
    m_forward->setToolTip(tr("Which of the model's own axes points to the bow"));
    m_up->setToolTip(tr("Which of the model's own axes points up"));
    m_fit->addItem(tr("to her length"), QStringLiteral("length"));
    m_fit->addItem(tr("to her length and beam"), QStringLiteral("length-and-beam"));
    m_fit->addItem(tr("by a scale"), QStringLiteral("scale"));
    m_fit->setToolTip(tr("How the model becomes the size of the ship"));
    m_scale->setRange(0.0001, 10000.0);
    m_scale->setDecimals(4);
    m_scale->setValue(1.0);
    m_scale->setToolTip(tr("Metres per unit of the model, 0.0001 to 10000"));
    m_licence->setToolTip(tr("Under which terms the model may be used: shown with the attributions"));
    m_licence->setPlaceholderText(tr("such as CC BY 4.0, or our own"));
    m_source->setToolTip(tr("Who made it and where it is from"));
    m_source->setPlaceholderText(tr("who made it, where it is from"));
    m_licence->setObjectName(QStringLiteral("licence"));
    m_source->setObjectName(QStringLiteral("source"));
    m_forward->setObjectName(QStringLiteral("forward"));
    m_up->setObjectName(QStringLiteral("up"));
    m_fit->setObjectName(QStringLiteral("fit"));
    m_waterline->setObjectName(QStringLiteral("waterline"));
    m_note->setWordWrap(true);
    m_note->setObjectName(QStringLiteral("modelNote"));
    m_file->setWordWrap(true);
    m_ok->setObjectName(QStringLiteral("save"));
    m_ok->setProperty("primary", true);
    m_ok->setToolTip(tr("Saves the vessel with this model as the school's own"));

    auto* const choose = new QPushButton(tr("Choose a file…"), this);
    choose->setToolTip(tr("AC3D, OBJ, glTF, Collada, 3DS, FBX, PLY or STL; textures as PNG beside it"));
    auto* const none = new QPushButton(tr("No model"), this);
    none->setToolTip(tr("The ship is drawn from her form"));
    auto* const fileRow = new QHBoxLayout;
    fileRow->addWidget(choose);
    fileRow->addWidget(none);
    fileRow->addStretch(1);
    auto* const form = new QFormLayout;
    form->addRow(tr("Model"), m_file);
    form->addRow(QString(), fileRow);
    form->addRow(tr("Forward is"), m_forward);
    form->addRow(tr("Up is"), m_up);
    form->addRow(tr("Size"), m_fit);
    form->addRow(tr("Scale"), m_scale);
    form->addRow(tr("Waterline at"), m_waterline);
    form->addRow(tr("Midship at"), m_midship);
    form->addRow(QString(), m_middle);
    form->addRow(tr("Licence"), m_licence);
    form->addRow(tr("Source"), m_source);
    auto* const left = new QWidget(this);
    auto* const leftLayout = new QVBoxLayout(left);
    leftLayout->addLayout(form);
    leftLayout->addWidget(lightTable());
    leftLayout->addStretch(1);
    auto* const scroll = new QScrollArea(this);
    scroll->setWidget(left);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setMinimumWidth(430);
    auto* const right = new QVBoxLayout;
    right->addWidget(m_view, 1);
    right->addWidget(m_night);
    right->addWidget(m_note);
    auto* const both = new QHBoxLayout;
    both->addWidget(scroll, 2);
    both->addLayout(right, 3);
    auto* const cancel = new QPushButton(tr("Cancel"), this);
    auto* const buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(cancel);
    buttons->addWidget(m_ok);
    auto* const layout = new QVBoxLayout(this);
    layout->addLayout(both, 1);
    layout->addLayout(buttons);

    readPicture();
    m_timer->setSingleShot(true);
    m_timer->setInterval(350);
    connect(m_timer, &QTimer::timeout, this, &ModelDialog::preview);
    connect(choose, &QPushButton::clicked, this, [this] {
        const QString file = QFileDialog::getOpenFileName(
            this, tr("3D model"), QString(),
            tr("3D models (*.ac *.obj *.gltf *.glb *.dae *.3ds *.fbx *.ply *.stl);;All files (*)"));
        if (file.isEmpty()) return;
        if (const auto trouble = takeFile(file.toStdString()))
            QMessageBox::warning(this, windowTitle(), QString::fromStdString(*trouble));
    });
    connect(none, &QPushButton::clicked, this, [this] {
        m_model.clear();
        change();
    });
    for (QComboBox* box : {m_forward, m_up, m_fit})
        connect(box, &QComboBox::currentIndexChanged, this, &ModelDialog::change);
    for (QDoubleSpinBox* spin : {m_scale, m_waterline, m_midship})
        connect(spin, &QDoubleSpinBox::valueChanged, this, &ModelDialog::change);
    for (QCheckBox* check : {m_middle, m_night})
        connect(check, &QCheckBox::toggled, this, &ModelDialog::change);
    for (QLineEdit* edit : {m_licence, m_source})
        connect(edit, &QLineEdit::textChanged, this, &ModelDialog::change);
    for (const LightRow& row : m_lights) {
        connect(row.on, &QCheckBox::toggled, this, &ModelDialog::change);
        for (QDoubleSpinBox* spin : {row.forward, row.starboard, row.height})
            connect(spin, &QDoubleSpinBox::valueChanged, this, &ModelDialog::change);
    }
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_ok, &QPushButton::clicked, this, &ModelDialog::accept);
    preview();
}

QDoubleSpinBox* ModelDialog::metres(double low, double high, const QString& tip) {
    auto* const spin = new QDoubleSpinBox(this);
    spin->setRange(low, high);
    spin->setDecimals(2);
    spin->setSingleStep(0.1);
    spin->setSuffix(tr(" m"));
    spin->setToolTip(tip + tr(" (%1 to %2)").arg(low).arg(high));
    return spin;
}

QWidget* ModelDialog::lightTable() {
    auto* const box = new QGroupBox(tr("Navigation lights, metres of the model"), this);
    auto* const grid = new QGridLayout(box);
    const QString heads[] = {tr("Light"), tr("Forward of midship"), tr("To starboard"),
                             tr("Above waterline")};
    for (int i = 0; i < 4; ++i) grid->addWidget(new QLabel(heads[i], box), 0, i);
    const std::array<QString, core::kLightPlaces> names{
        tr("Masthead forward"), tr("Masthead aft"), tr("Port side"), tr("Starboard side"), tr("Stern"),
        tr("Anchor forward"),   tr("Anchor aft")};
    for (std::size_t i = 0; i < m_lights.size(); ++i) {
        LightRow& row = m_lights[i];
        row.on = new QCheckBox(names[i], box);
        row.on->setToolTip(tr("Off: where it usually is on such a ship"));
        row.forward = metres(-1000, 1000, tr("Forward of midship"));
        row.starboard = metres(-200, 200, tr("To starboard of the centreline"));
        row.height = metres(0, 500, tr("Above the waterline"));
        QWidget* const cells[] = {row.on, row.forward, row.starboard, row.height};
        for (int c = 0; c < 4; ++c) grid->addWidget(cells[c], static_cast<int>(i) + 1, c);
    }
    return box;
}

void ModelDialog::readPicture() {
    const Json json = Json::parse(m_text, nullptr, false);
    const Json picture = json.is_object() && json.contains("picture") ? json["picture"] : Json::object();
    m_model = wordIn(picture, "model", "");
    m_licence->setText(QString::fromStdString(wordIn(picture, "licence", "")));
    m_source->setText(QString::fromStdString(wordIn(picture, "source", "")));
    m_forward->setCurrentText(QString::fromStdString(wordIn(picture, "forward", "+x")));
    m_up->setCurrentText(QString::fromStdString(wordIn(picture, "up", "+z")));
    m_scale->setValue(numberIn(picture, "scale", 1.0));
    m_fit->setCurrentIndex(picture.contains("scale")                               ? 2
                           : wordIn(picture, "fit", "length") == "length-and-beam" ? 1
                                                                                   : 0);
    m_waterline->setValue(numberIn(picture, "waterline_m", 0.0));
    m_middle->setChecked(!picture.contains("midship_m"));
    m_midship->setValue(numberIn(picture, "midship_m", 0.0));
    if (!picture.contains("lights")) return;
    for (const Json& light : picture["lights"]) {
        for (std::size_t i = 0; i < kLightKinds.size(); ++i) {
            if (wordIn(light, "kind", "") != kLightKinds[i]) continue;
            m_lights[i].on->setChecked(true);
            m_lights[i].forward->setValue(numberIn(light, "forward_m", 0.0));
            m_lights[i].starboard->setValue(numberIn(light, "starboard_m", 0.0));
            m_lights[i].height->setValue(numberIn(light, "height_m", 0.0));
        }
    }
}

std::optional<std::string> ModelDialog::takeFile(const std::filesystem::path& file) {
    const auto vessel = core::loadVessel("vessel", m_text);
    const auto files = gatherModel(file, vessel ? vessel->id : "vessel");
    if (!files) return files.error();
    if (auto trouble = writeAttached(*files, m_ownModels)) return trouble;
    m_model = files->front().path;
    change();
    return std::nullopt;
}

std::string ModelDialog::text() const {
    Json json = Json::parse(m_text, nullptr, false);
    if (m_model.empty()) {
        json.erase("picture");
        return json.dump(2) + "\n";
    }
    Json picture = json.contains("picture") ? json["picture"] : Json::object();
    if (wordIn(picture, "model", "") != m_model) picture = Json::object();  // names of objects are another's
    picture["model"] = m_model;
    picture["licence"] = m_licence->text().toStdString();
    picture["forward"] = m_forward->currentText().toStdString();
    picture["up"] = m_up->currentText().toStdString();
    picture.erase("scale");
    picture.erase("fit");
    if (m_fit->currentIndex() == 2)
        picture["scale"] = m_scale->value();
    else
        picture["fit"] = m_fit->currentData().toString().toStdString();
    picture["waterline_m"] = m_waterline->value();
    picture.erase("midship_m");
    if (!m_middle->isChecked()) picture["midship_m"] = m_midship->value();
    picture["lights"] = Json::array();
    for (std::size_t i = 0; i < m_lights.size(); ++i) {
        const LightRow& row = m_lights[i];
        if (!row.on->isChecked()) continue;
        picture["lights"].push_back({{"kind", kLightKinds[i]},
                                     {"forward_m", row.forward->value()},
                                     {"starboard_m", row.starboard->value()},
                                     {"height_m", row.height->value()}});
    }
    picture["source"] = m_source->text().toStdString();
    if (!picture.contains("quality")) picture["quality"] = "estimated";
    json["picture"] = picture;
    return json.dump(2) + "\n";
}

void ModelDialog::change() { m_timer->start(); }

void ModelDialog::preview() {
    m_scale->setEnabled(m_fit->currentIndex() == 2);
    m_midship->setEnabled(!m_middle->isChecked());
    for (const LightRow& row : m_lights)
        for (QDoubleSpinBox* spin : {row.forward, row.starboard, row.height})
            spin->setEnabled(row.on->isChecked());
    m_file->setText(m_model.empty() ? tr("none: the ship is drawn from her form")
                                    : QString::fromStdString(m_model));
    const auto vessel = core::loadVessel("vessel", text());
    m_ok->setEnabled(static_cast<bool>(vessel));
    if (!vessel) {
        QString problems;
        for (const core::config::Problem& p : vessel.error().list())
            problems += QStringLiteral("%1 %2; %3 %4\n")
                            .arg(QString::fromStdString(p.path), QString::fromStdString(p.found),
                                 tr("accepted:"), QString::fromStdString(p.expected));
        m_note->setText(problems.trimmed());
        return;
    }
    m_note->setText(tr("Set waterline and size until she floats at her marks; turn her by the axes."));
    m_view->setNight(m_night->isChecked());
    m_view->setVessel(*vessel);
}

void ModelDialog::accept() {
    if (!core::loadVessel("vessel", text())) return;
    if (const auto trouble = m_save(text())) {
        if (!trouble->empty()) QMessageBox::warning(this, windowTitle(), QString::fromStdString(*trouble));
        return;
    }
    QDialog::accept();
}

}  // namespace sagara::ui
