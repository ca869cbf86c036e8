#include "ui/vessels/DocumentTree.h"

#include <QHeaderView>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/Config.h"
#include "ui/theme/ThemeColours.h"
#include "ui/vessels/FieldNames.h"

namespace sagara::ui {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kPointer = Qt::UserRole;
constexpr int kPath = Qt::UserRole + 1;
constexpr int kAbout = Qt::UserRole + 2;  ///< what the last column says when nothing is wrong

/// Only values are edited.
class ValueDelegate final : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override {
        if (index.column() != DocumentTree::Value) return nullptr;
        return QStyledItemDelegate::createEditor(parent, option, index);
    }
};

QString textOf(const Json& value) {
    if (value.is_string()) return QString::fromStdString(value.get<std::string>());
    if (value.is_number()) return QString::fromStdString(core::config::formatNumber(value.get<double>()));
    if (value.is_boolean()) return value.get<bool>() ? QStringLiteral("true") : QStringLiteral("false");
    return {};
}

/// What was typed, as the kind of value that stood there; what does not fit stays text for the loader to
/// refuse.
Json valueOf(const QString& typed, const Json& before) {
    const QString text = typed.trimmed();
    if (before.is_boolean()) {
        if (text == QLatin1String("true")) return true;
        if (text == QLatin1String("false")) return false;
    }
    if (before.is_number() || !before.is_string()) {
        bool ok = false;
        const double number = QString(text).replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&ok);
        if (ok) return number;
    }
    return text.toStdString();
}

/// What tells an item of a list from the others.
QString titleOf(const Json& item, std::size_t index) {
    for (const char* key : {"id", "kind", "of", "name"})
        if (item.is_object() && item.contains(key)) return textOf(item[key]);
    return QStringLiteral("%1").arg(index + 1);
}

}  // namespace

DocumentTree::DocumentTree(Use use, QWidget* parent)
    : QTreeWidget(parent), m_use(use), m_json(std::make_unique<Json>()) {
    setObjectName(QStringLiteral("documentTree"));
    setColumnCount(4);
    setHeaderLabels({tr("Field"), tr("Value"), tr("Unit"),
                     use == Use::Edit ? tr("Source, or what is wrong") : tr("Quality and source")});
    setAlternatingRowColors(true);
    setUniformRowHeights(true);
    setItemDelegate(new ValueDelegate(this));
    header()->setSectionResizeMode(QHeaderView::Interactive);
    header()->resizeSection(Name, 260);
    header()->resizeSection(Value, 150);
    header()->resizeSection(Unit, 70);
    header()->setStretchLastSection(true);
    setEditTriggers(use == Use::Edit
                        ? QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                              QAbstractItemView::AnyKeyPressed | QAbstractItemView::SelectedClicked
                        : QAbstractItemView::NoEditTriggers);
    connect(this, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int column) {
        if (!m_filling && column == Value) take(item);
    });
}

DocumentTree::~DocumentTree() = default;

void DocumentTree::setDocument(const std::string& text) {
    const std::string here = currentPath();
    std::set<QString> open;
    for (QTreeWidgetItemIterator it(this); *it; ++it)
        if ((*it)->isExpanded()) open.insert((*it)->data(0, kPath).toString());
    *m_json = Json::parse(text, nullptr, false);
    m_filling = true;
    clear();
    if (m_json->is_object()) {
        for (const auto& [key, value] : m_json->items()) {
            if (m_use == Use::Read && (key == "document" || key == "version")) continue;
            fill(invisibleRootItem(), key, value, "/" + key, key);
        }
    }
    m_filling = false;
    for (QTreeWidgetItemIterator it(this); *it; ++it)
        if (open.count((*it)->data(0, kPath).toString()) > 0) (*it)->setExpanded(true);
    if (!here.empty()) choose(here);
}

void DocumentTree::fill(QTreeWidgetItem* parent, const std::string& key, const Json& value,
                        const std::string& pointer, const std::string& path) {
    auto* const item = new QTreeWidgetItem(parent);
    const FieldName name = fieldName(key);
    item->setText(Name, name.label);
    item->setToolTip(Name, QString::fromStdString(path));
    item->setText(Unit, name.unit);
    item->setData(0, kPointer, QString::fromStdString(pointer));
    item->setData(0, kPath, QString::fromStdString(path));
    if (value.is_object() && value.contains("source") && value.contains("quality")) {
        const QString source = textOf(value["source"]), quality = textOf(value["quality"]);
        item->setText(Value, quality);
        item->setData(0, kAbout, source);
        item->setText(About, source);
        item->setToolTip(About, QStringLiteral("<p>%1: %2</p>").arg(quality, source.toHtmlEscaped()));
        QFont bold = font();
        bold.setBold(true);
        item->setFont(Name, bold);
    }
    if (value.is_object()) {
        for (const auto& [child, inner] : value.items()) {
            if (m_use == Use::Read && (child == "source" || child == "quality")) continue;
            fill(item, child, inner, pointer + "/" + child, path + "." + child);
        }
        return;
    }
    if (value.is_array()) {
        std::size_t i = 0;
        for (const Json& inner : value) {
            const std::string index = std::to_string(i);
            fill(item, key, inner, pointer + "/" + index, path + "[" + index + "]");
            item->child(static_cast<int>(i))->setText(Name, titleOf(inner, i));
            ++i;
        }
        if (!value.empty() && value[0].is_number() && value.size() <= 4) {
            QStringList numbers;
            for (const Json& inner : value) numbers += textOf(inner);
            item->setText(About, numbers.join(QStringLiteral(", ")));
        }
        return;
    }
    item->setText(Value, textOf(value));
    item->setToolTip(Value, textOf(value));
    item->setTextAlignment(
        Value, value.is_number() ? Qt::AlignRight | Qt::AlignVCenter : Qt::AlignLeft | Qt::AlignVCenter);
    if (m_use == Use::Edit) item->setFlags(item->flags() | Qt::ItemIsEditable);
}

void DocumentTree::take(QTreeWidgetItem* item) {
    const Json::json_pointer pointer(item->data(0, kPointer).toString().toStdString());
    Json& value = m_json->at(pointer);
    const Json now = valueOf(item->text(Value), value);
    if (now == value) return;
    value = now;
    Q_EMIT edited();
}

std::string DocumentTree::text() const { return m_json->dump(2) + "\n"; }

void DocumentTree::setProblems(const core::config::Problems& problems) {
    const ThemeColours& c = themeColours(m_colours);
    m_filling = true;
    for (QTreeWidgetItemIterator it(this); *it; ++it) {
        QTreeWidgetItem* const item = *it;
        if (item->data(About, Qt::ForegroundRole).isValid()) {
            for (const int column : {Name, Value, About}) item->setData(column, Qt::ForegroundRole, {});
            item->setText(About, item->data(0, kAbout).toString());
        }
    }
    for (const core::config::Problem& p : problems.list()) {
        std::string path = p.path;
        QTreeWidgetItem* item = itemAt(path);
        while (item == nullptr && path.find_last_of(".[") != std::string::npos) {  // what is missing
            path.resize(path.find_last_of(".["));
            item = itemAt(path);
        }
        if (item == nullptr) continue;
        const QString what =
            tr("%1; accepted: %2").arg(QString::fromStdString(p.found), QString::fromStdString(p.expected));
        item->setText(About, path == p.path ? what
                                            : QString::fromStdString(p.path.substr(path.size() + 1)) +
                                                  QLatin1Char(' ') + what);
        item->setToolTip(About, item->text(About));
        for (const int column : {Name, Value, About}) item->setForeground(column, c.alarm);
        for (QTreeWidgetItem* up = item->parent(); up != nullptr; up = up->parent())
            up->setForeground(Name, c.alarm), up->setForeground(About, palette().text());
    }
    m_filling = false;
}

void DocumentTree::setColours(PaletteName name) { m_colours = name; }

void DocumentTree::setFilter(const QString& text) {
    const auto shows = [&](auto&& self, QTreeWidgetItem* item, bool all) -> bool {
        const bool here = all || text.isEmpty() || item->text(Name).contains(text, Qt::CaseInsensitive) ||
                          item->toolTip(Name).contains(text, Qt::CaseInsensitive) ||
                          item->text(Value).contains(text, Qt::CaseInsensitive);
        bool any = here;
        for (int i = 0; i < item->childCount(); ++i) any = self(self, item->child(i), here) || any;
        item->setHidden(!any);
        if (any && !text.isEmpty() && !here) item->setExpanded(true);
        return any;
    };
    for (int i = 0; i < topLevelItemCount(); ++i) shows(shows, topLevelItem(i), false);
}

QTreeWidgetItem* DocumentTree::itemAt(const std::string& path) const {
    const QString wanted = QString::fromStdString(path);
    for (QTreeWidgetItemIterator it(const_cast<DocumentTree*>(this)); *it; ++it)
        if ((*it)->data(0, kPath).toString() == wanted) return *it;
    return nullptr;
}

std::string DocumentTree::currentPath() const {
    return currentItem() ? currentItem()->data(0, kPath).toString().toStdString() : std::string();
}

bool DocumentTree::choose(const std::string& path) {
    QTreeWidgetItem* const item = itemAt(path);
    if (item == nullptr) return false;
    setCurrentItem(item);
    scrollToItem(item);
    return true;
}

QTreeWidgetItem* DocumentTree::listItem() const {
    for (QTreeWidgetItem* item = currentItem(); item && item->parent(); item = item->parent()) {
        const Json::json_pointer list(item->parent()->data(0, kPointer).toString().toStdString());
        if (m_json->at(list).is_array()) return item;
    }
    return nullptr;
}

bool DocumentTree::canAdd() const { return m_use == Use::Edit && listItem() != nullptr; }
bool DocumentTree::canRemove() const { return canAdd(); }

bool DocumentTree::addLikeCurrent() {
    QTreeWidgetItem* const item = listItem();
    if (item == nullptr) return false;
    const int index = item->parent()->indexOfChild(item);
    Json& list = m_json->at(Json::json_pointer(item->parent()->data(0, kPointer).toString().toStdString()));
    Json copy = list[static_cast<std::size_t>(index)];
    if (copy.is_object() && copy.contains("id") && copy["id"].is_string())
        copy["id"] = copy["id"].get<std::string>() + "-2";
    list.insert(list.begin() + index + 1, std::move(copy));
    const std::string path =
        item->parent()->data(0, kPath).toString().toStdString() + "[" + std::to_string(index + 1) + "]";
    setDocument(text());
    choose(path);
    Q_EMIT edited();
    return true;
}

bool DocumentTree::removeCurrent() {
    QTreeWidgetItem* const item = listItem();
    if (item == nullptr) return false;
    const int index = item->parent()->indexOfChild(item);
    const std::string list = item->parent()->data(0, kPath).toString().toStdString();
    m_json->at(Json::json_pointer(item->parent()->data(0, kPointer).toString().toStdString()))
        .erase(static_cast<std::size_t>(index));
    setDocument(text());
    choose(list);
    Q_EMIT edited();
    return true;
}

}  // namespace sagara::ui
