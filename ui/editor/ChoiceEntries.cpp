#include <QCheckBox>
#include <QComboBox>
#include <QDateTimeEdit>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "core/base/Utc.h"
#include "ui/editor/FieldEntries.h"

namespace sagara::ui::editor {
namespace {

class WheelGuard final : public QObject {
public:
    using QObject::QObject;
    bool eventFilter(QObject* watched, QEvent* event) override {
        const auto* widget = qobject_cast<QWidget*>(watched);
        if (event->type() != QEvent::Wheel || !widget || widget->hasFocus()) return false;
        event->ignore();
        return true;
    }
};

QString plain(const Json* value) {
    if (!value) return {};
    return QString::fromStdString(value->is_string() ? value->get<std::string>() : value->dump());
}

std::vector<std::string> textsOf(const Json* list) {
    std::vector<std::string> all;
    if (!list || !list->is_array()) return all;
    for (const Json& item : *list)
        if (item.is_string()) all.push_back(item.get<std::string>());
    return all;
}

}  // namespace

void keepWheelForPage(QWidget& widget) {
    widget.setFocusPolicy(Qt::StrongFocus);
    widget.installEventFilter(new WheelGuard(&widget));
}

void fillCombo(QComboBox& combo, const std::vector<Option>& options, bool optional, const QString& value) {
    const QSignalBlocker quiet(combo);
    QList<QPair<QString, QString>> items;  // value, label
    if (optional) items.append({QString(), QStringLiteral("–")});
    for (const Option& o : options) items.append({QString::fromStdString(o.value), o.label});
    const bool known = value.isEmpty() || std::any_of(items.begin(), items.end(),
                                                      [&](const auto& i) { return i.first == value; });
    if (!known) items.append({value, words("%1 (not known)").arg(value)});
    bool same = combo.count() == items.size();
    for (int i = 0; same && i < combo.count(); ++i)
        same = combo.itemData(i).toString() == items[i].first && combo.itemText(i) == items[i].second;
    if (!same) {
        combo.clear();
        for (const auto& [data, label] : items) combo.addItem(label, data);
    }
    combo.setCurrentIndex(
        combo.findData(value.isEmpty() && !optional ? QVariant(QStringLiteral("?")) : QVariant(value)));
}

ChoiceEntry::ChoiceEntry(EditorContext& context, const Field& field, const std::string& path, QWidget* parent)
    : FieldEditor(context, field, path, parent), m_combo(new QComboBox(this)) {
    m_combo->setObjectName(QString::fromStdString(path));
    m_combo->setToolTip(tip());
    m_combo->setPlaceholderText(words("choose"));
    m_combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_combo->setMinimumContentsLength(12);
    keepWheelForPage(*m_combo);
    box()->addWidget(m_combo);
    connect(m_combo, &QComboBox::currentIndexChanged, this, [this](int index) {
        const QString chosen = m_combo->itemData(index).toString();
        if (chosen.isEmpty()) return write(Json());
        write(this->field().source == Source::Waypoint ? Json(chosen.toInt()) : Json(chosen.toStdString()));
    });
    connect(&context, &EditorContext::areaChanged, this, &ChoiceEntry::load);
}

void ChoiceEntry::load() {
    const bool named = field().source != Source::None;
    fillCombo(*m_combo, named ? context().choices(field().source, path()) : field().options, field().optional,
              plain(value()));
}

void ChoiceEntry::focusEntry() { m_combo->setFocus(); }

ReferencesEntry::ReferencesEntry(EditorContext& context, const Field& field, const std::string& path,
                                 QWidget* parent)
    : FieldEditor(context, field, path, parent), m_grid(new QGridLayout) {
    m_grid->setContentsMargins(0, 2, 0, 2);
    box()->addLayout(m_grid);
    connect(&context, &EditorContext::areaChanged, this, &ReferencesEntry::load);
}

void ReferencesEntry::load() {
    const std::vector<std::string> chosen = textsOf(value());
    std::vector<Option> options = context().choices(field().source, path());
    for (const std::string& id : chosen) {
        if (std::none_of(options.begin(), options.end(), [&](const Option& o) { return o.value == id; }))
            options.push_back({id, words("%1 (not known)").arg(QString::fromStdString(id))});
    }
    const auto nameOf = [this](const Option& o) { return QString::fromStdString(path() + "/" + o.value); };
    bool same = m_boxes.size() == options.size();
    for (std::size_t i = 0; same && i < options.size(); ++i)
        same = m_boxes[i]->objectName() == nameOf(options[i]) && m_boxes[i]->text() == options[i].label;
    if (!same) {
        while (QLayoutItem* item = m_grid->takeAt(0)) {
            delete item->widget();
            delete item;
        }
        m_boxes.clear();
        for (std::size_t i = 0; i < options.size(); ++i) {
            auto* const check = new QCheckBox(options[i].label, this);
            check->setObjectName(nameOf(options[i]));
            check->setToolTip(tip());
            check->setProperty("value", QString::fromStdString(options[i].value));
            connect(check, &QCheckBox::clicked, this, &ReferencesEntry::take);
            m_grid->addWidget(check, static_cast<int>(i) / 2, static_cast<int>(i) % 2);
            m_boxes.push_back(check);
        }
        if (options.empty())
            m_grid->addWidget(new QLabel(words("There are none to choose from."), this), 0, 0);
    }
    for (std::size_t i = 0; i < options.size(); ++i)
        m_boxes[i]->setChecked(std::find(chosen.begin(), chosen.end(), options[i].value) != chosen.end());
}

void ReferencesEntry::take() {
    Json all = Json::array();
    for (const QCheckBox* check : m_boxes)
        if (check->isChecked()) all.push_back(check->property("value").toString().toStdString());
    write(all.empty() && field().optional ? Json() : std::move(all));
}

void ReferencesEntry::focusEntry() {
    if (!m_boxes.empty()) m_boxes.front()->setFocus();
}

UtcEntry::UtcEntry(EditorContext& context, const Field& field, const std::string& path, QWidget* parent)
    : FieldEditor(context, field, path, parent), m_when(new QDateTimeEdit(this)), m_local(new QLabel(this)) {
    m_when->setObjectName(QString::fromStdString(path));
    m_when->setToolTip(tip());
    m_when->setTimeSpec(Qt::UTC);
    m_when->setDisplayFormat(QStringLiteral("yyyy-MM-dd HH:mm:ss 'UTC'"));
    m_when->setCalendarPopup(true);
    keepWheelForPage(*m_when);
    m_local->setObjectName(QStringLiteral("local-time"));
    m_local->setWordWrap(true);
    box()->addWidget(m_when);
    box()->addWidget(m_local);
    connect(m_when, &QDateTimeEdit::dateTimeChanged, this,
            [this](const QDateTime& when) { write(Json(core::formatUtc({when.toSecsSinceEpoch()})), true); });
    connect(&context, &EditorContext::areaChanged, this, &UtcEntry::load);
}

void UtcEntry::load() {
    const auto start =
        core::parseUtc(value() && value()->is_string() ? value()->get<std::string>() : std::string());
    m_local->setVisible(start.has_value() && context().area() != nullptr);
    if (!start) return;
    const QSignalBlocker quiet(m_when);
    const QDateTime when = QDateTime::fromSecsSinceEpoch(start->unix_s, Qt::UTC);
    if (m_when->dateTime() != when) m_when->setDateTime(when);
    if (const core::Area* area = context().area().get()) {
        m_local->setText(words("%1 local time there (%2)")
                             .arg(QString::fromStdString(core::formatLocal(*start, area->utcOffset_min)),
                                  QString::fromStdString(area->timeZone)));
    }
}

void UtcEntry::focusEntry() { m_when->setFocus(); }

}  // namespace sagara::ui::editor
