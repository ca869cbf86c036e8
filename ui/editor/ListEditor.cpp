#include "ui/editor/ListEditor.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <set>

#include "ui/editor/FieldEntries.h"
#include "ui/editor/FieldText.h"
#include "ui/editor/ObjectForm.h"
#include "ui/editor/RowsModel.h"
#include "ui/editor/ScenarioFields.h"

namespace sagara::ui::editor {
namespace {

constexpr int kFewestRows = 2, kMostRows = 7;
constexpr double kApart_deg = 0.002;  ///< between the ends of a new gate

bool nested(const std::string& path) { return path.find('[') != std::string::npos; }

}  // namespace

ListEditor::ListEditor(EditorContext& context, const Field& field, const std::string& path, QWidget* parent)
    : FieldEditor(context, field, path, parent),
      m_model(new RowsModel(context, *this->field().list, path, this)),
      m_table(new QTableView(this)),
      m_rowBox(new QWidget(this)),
      m_rowTitle(new QLabel(this)),
      m_kind(new QComboBox(this)) {
    m_table->setObjectName(QString::fromStdString(path));
    m_table->setToolTip(field.hint);
    m_table->setModel(m_model);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setAlternatingRowColors(true);
    m_table->setWordWrap(false);
    m_table->setTabKeyNavigation(false);
    m_table->verticalHeader()->setDefaultSectionSize(26);
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    if (spec().form)
        m_table->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    else
        m_table->setEditTriggers(QAbstractItemView::AllEditTriggers);
    box()->addWidget(m_table);
    if (spec().fixed == 0) addButtons();
    auto* const inside = new QVBoxLayout(m_rowBox);
    inside->setContentsMargins(nested(path) ? 8 : 0, 4, 0, 0);
    QFont bold = m_rowTitle->font();
    bold.setBold(true);
    m_rowTitle->setFont(bold);
    auto* const head = new QHBoxLayout;
    head->addWidget(m_rowTitle);
    head->addWidget(m_kind, 1);
    inside->addLayout(head);
    box()->addWidget(m_rowBox);
    for (const Variant& v : spec().variants) m_kind->addItem(v.label, QString::fromStdString(v.value));
    m_kind->setVisible(!spec().variants.empty());
    m_kind->setPlaceholderText(words("choose"));
    m_kind->setToolTip(words("Kind of %1").arg(spec().one));
    keepWheelForPage(*m_kind);
    connect(m_kind, &QComboBox::currentIndexChanged, this, &ListEditor::takeKind);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& now) { choose(now.isValid() ? now.row() : -1); });
    connect(&context, &EditorContext::areaChanged, this, &ListEditor::load);
}

void ListEditor::addButtons() {
    auto* const row = new QHBoxLayout;
    row->setSpacing(4);
    const auto button = [&](const char* name, const QString& text, const QString& hint, auto&& work) {
        auto* const b = new QToolButton(this);
        b->setObjectName(QString::fromStdString(path() + "." + name));
        b->setText(text);
        b->setToolTip(hint);
        b->setAccessibleName(hint);
        connect(b, &QToolButton::clicked, this, work);
        row->addWidget(b);
        return b;
    };
    const QString& one = spec().one;
    addKinds(*button("add", words("Add %1").arg(one), words("Add a new %1 at the end").arg(one),
                     [this] { add(spec().variants.empty() ? nullptr : &spec().variants.front(), -1); }));
    m_ofRow = {
        button("insert", words("Insert"), words("Insert a new %1 before the chosen one").arg(one),
               [this] { add(spec().variantOf(*this->context().draft().at(rowPath(m_row))), m_row); }),
        button("copy", words("Copy"), words("Copy the chosen %1").arg(one), [this] { copy(); }),
        button("delete", words("Delete"), words("Delete the chosen %1").arg(one), [this] { remove(); }),
        button("up", QStringLiteral("▲"), words("Move the chosen %1 up").arg(one), [this] { move(-1); }),
        button("down", QStringLiteral("▼"), words("Move the chosen %1 down").arg(one), [this] { move(1); })};
    row->addStretch(1);
    box()->addLayout(row);
}

/// A list with kinds asks which.
void ListEditor::addKinds(QToolButton& button) {
    if (spec().variants.size() < 2) return;
    auto* const menu = new QMenu(&button);
    for (const Variant& v : spec().variants) {
        QAction* const action = menu->addAction(v.label, this, [this, &v] { add(&v, -1); });
        action->setObjectName(QString::fromStdString(path() + ".add." + v.value));
    }
    button.setMenu(menu);
    button.setPopupMode(QToolButton::MenuButtonPopup);
}

Json ListEditor::newRow(const Variant* variant) const {
    Json row = initialRow(spec(), variant);
    const std::string at = rowPath(m_model->rowCount());
    std::vector<Field> fields = spec().common;
    if (variant) fields.insert(fields.end(), variant->fields.begin(), variant->fields.end());
    for (const Field& f : fields) {
        const std::string where = join(at, f.key);
        if (f.optional && spec().form) continue;
        if (f.kind == FieldKind::Position || f.kind == FieldKind::Place) {
            put(row, f.key, positionJson(context().newPlace()));
        } else if (f.kind == FieldKind::Places) {
            Json all = Json::array();
            for (std::size_t i = 0; i < f.count; ++i) {
                core::GeoPoint place = context().newPlace();
                place.lon_deg +=
                    kApart_deg * (static_cast<double>(i) - 0.5 * static_cast<double>(f.count - 1));
                all.push_back(positionJson(place));
            }
            put(row, f.key, std::move(all));
        } else if (f.kind == FieldKind::Reference) {
            const std::vector<Option> options = context().choices(f.source, where);
            if (options.empty()) continue;
            const std::string& first = options.front().value;
            put(row, f.key, f.source == Source::Waypoint ? Json(std::stoi(first)) : Json(first));
        } else if (f.kind == FieldKind::References) {
            put(row, f.key, Json::array());
        } else if (f.kind == FieldKind::Numbers && f.initial.is_null()) {
            put(row, f.key, Json(std::vector<int>(context().shafts(where), 0)));
        }
    }
    return row;
}

void ListEditor::add(const Variant* variant, int before) {
    insert(newRow(variant), before, words("new %1").arg(spec().one));
}

/// With an id of its own.
void ListEditor::insert(Json row, int before, const QString& what) {
    if (!spec().idBase.empty()) {
        std::set<std::string> taken;
        for (int i = 0; i < m_model->rowCount(); ++i)
            taken.insert(textAt(context().draft().document(), join(rowPath(i), "id")));
        int number = m_model->rowCount() + 1;
        while (taken.contains(spec().idBase + "-" + std::to_string(number))) ++number;
        const Json id = spec().idBase + "-" + std::to_string(number);
        if (spec().field("id")) row["id"] = id;
    }
    if (spec().ownNames) {
        std::set<std::string> names;
        for (int i = 0; i < m_model->rowCount(); ++i)
            names.insert(textAt(context().draft().document(), join(rowPath(i), "name")));
        row["name"] = freshName(textAt(row, "name"), names);
    }
    const int at = before < 0 ? m_model->rowCount() : before;
    context().draft().edit(what, [&](Json& document) {
        const std::string outer = parentOf(path());
        if (!spec().parent.is_null() && !editor::find(document, outer)) put(document, outer, spec().parent);
        if (sizeAt(document, path()) == 0) put(document, path(), Json::array());
        Json all = *editor::find(document, path());
        all.insert(all.begin() + at, std::move(row));
        put(document, path(), std::move(all));
    });
    m_table->selectRow(at);
    m_table->scrollTo(m_model->index(at, 0));
    showRow();
}

void ListEditor::copy() {
    if (m_row < 0) return;
    insert(*context().draft().at(rowPath(m_row)), m_row + 1, words("copy of %1").arg(spec().one));
}

void ListEditor::remove() {
    if (m_row < 0) return;
    const int row = m_row;
    context().draft().edit(words("%1 deleted").arg(spec().one), [&](Json& document) {
        erase(document, rowPath(row));
        const std::string outer = parentOf(path());
        if (sizeAt(document, path()) > 0) return;
        if (field().optional) erase(document, path());
        if (!spec().parent.is_null()) erase(document, outer);
    });
    if (m_model->rowCount() > 0) m_table->selectRow(std::min(row, m_model->rowCount() - 1));
}

void ListEditor::move(int by) {
    const int to = m_row + by;
    if (m_row < 0 || to < 0 || to >= m_model->rowCount()) return;
    context().draft().edit(words("%1 moved").arg(spec().one), [&](Json& document) {
        Json all = *editor::find(document, path());
        std::swap(all[static_cast<std::size_t>(m_row)], all[static_cast<std::size_t>(to)]);
        put(document, path(), std::move(all));
    });
    m_table->selectRow(to);
}

void ListEditor::choose(int row) {
    m_row = row;
    showRow();
    if (row >= 0 && isVisible()) context().select(rowPath(row));
}

void ListEditor::showEvent(QShowEvent* event) {
    FieldEditor::showEvent(event);
    if (m_row >= 0 && !nested(path())) context().select(rowPath(m_row));
}

void ListEditor::fitTable() {
    const int rows =
        std::clamp(m_model->rowCount(), kFewestRows, std::max(kMostRows, static_cast<int>(spec().fixed)));
    m_table->setFixedHeight(m_table->horizontalHeader()->sizeHint().height() + rows * 26 + 18);
    m_table->horizontalHeader()->setStretchLastSection(false);
    m_table->resizeColumnsToContents();
    for (int i = 0; i + 1 < m_model->columnCount(); ++i)
        m_table->setColumnWidth(i, std::clamp(m_table->columnWidth(i), 60, 210));
    m_table->horizontalHeader()->setStretchLastSection(true);
}

void ListEditor::load() {
    m_model->refresh();
    fitTable();
    if (m_row >= m_model->rowCount()) m_row = m_model->rowCount() - 1;
    if (m_row < 0 && m_model->rowCount() > 0) m_table->selectRow(0);
    showRow();
}

void ListEditor::showRow() {
    const Json* const row = m_row < 0 ? nullptr : context().draft().at(rowPath(m_row));
    for (QToolButton* button : m_ofRow) button->setEnabled(row != nullptr);
    m_rowBox->setVisible(spec().form && row != nullptr);
    if (!spec().form || !row) return;
    const Variant* const variant = spec().variantOf(*row);
    if (!m_form || m_formRow != m_row || m_formVariant != variant) {
        if (m_form) {
            m_form->setParent(nullptr);  // it may be in the middle of a signal
            m_form->deleteLater();
        }
        m_form = new ObjectForm(context(), spec().fieldsOf(*row), rowPath(m_row), m_rowBox);
        m_rowBox->layout()->addWidget(m_form);
        m_formRow = m_row;
        m_formVariant = variant;
        m_form->show();
    }
    const QString one = spec().one.left(1).toUpper() + spec().one.mid(1);
    m_rowTitle->setText(words("%1 %2").arg(one).arg(m_row + 1));
    const QSignalBlocker quiet(m_kind);
    m_kind->setObjectName(QString::fromStdString(rowPath(m_row) + "#kind"));
    m_kind->setCurrentIndex(variant ? m_kind->findData(QString::fromStdString(variant->value)) : -1);
    m_form->load();
    m_form->showProblems(m_problems);
}

/// What the two kinds have in common stays; what only the old one had goes.
void ListEditor::takeKind() {
    const Json* const row = m_row < 0 ? nullptr : context().draft().at(rowPath(m_row));
    const int chosen = m_kind->currentIndex();
    if (!row || chosen < 0) return;
    const Variant& variant = spec().variants[static_cast<std::size_t>(chosen)];
    if (&variant == spec().variantOf(*row)) return;
    const Json fresh = newRow(&variant);
    context().draft().edit(words("kind of %1").arg(spec().one), [&](Json& document) {
        Json now = *editor::find(document, rowPath(m_row));
        for (const Variant& other : spec().variants) {
            if (&other == &variant) continue;
            for (const Field& f : other.fields) {
                const std::string outer = f.key.substr(0, f.key.find('.'));
                if (!fresh.contains(outer)) now.erase(outer);
            }
        }
        for (const auto& [key, value] : fresh.items())
            if (!now.contains(key) || key == spec().kindKey) now[key] = value;
        put(document, rowPath(m_row), std::move(now));
    });
}

void ListEditor::showProblems(const std::vector<core::config::Problem>& problems) {
    m_problems = problems;
    m_model->showProblems(problems);
    std::vector<core::config::Problem> own;
    for (const auto& p : problems) {
        const bool ofRow = p.path.starts_with(path() + "[") &&
                           p.path.find_first_of(".[", path().size() + 1) == std::string::npos;
        if (p.path == path() || (ofRow && p.path == rowPath(m_row))) own.push_back(p);
    }
    FieldEditor::showProblems(own);
    if (m_form && m_rowBox->isVisibleTo(this)) m_form->showProblems(problems);
}

FieldEditor* ListEditor::reveal(const std::string& target) {
    if (!target.starts_with(path() + "[")) return this;
    const int row = static_cast<int>(indexOf(target.substr(0, target.find(']', path().size()) + 1)));
    if (row >= m_model->rowCount()) return this;
    m_table->selectRow(row);
    FieldEditor* const inside = spec().form && m_form ? m_form->reveal(target) : nullptr;
    return inside && target != rowPath(row) ? inside : this;
}

void ListEditor::focusEntry() { m_table->setFocus(); }

}  // namespace sagara::ui::editor
