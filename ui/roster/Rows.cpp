#include "ui/roster/Rows.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>
#include <QSortFilterProxyModel>
#include <QStyledItemDelegate>
#include <algorithm>
#include <utility>

#include "ui/theme/KeptTables.h"
#include "ui/theme/ThemeColours.h"

namespace sagara::ui::roster {
namespace {

constexpr int kPadding_px = 26;
constexpr int kSide_px = 7;  ///< as the sections of the header have

/// Every word somewhere in the row.
class Searched final : public QSortFilterProxyModel {
public:
    using QSortFilterProxyModel::QSortFilterProxyModel;
    void setWords(const QStringList& words) {
        m_words = words;
        invalidateFilter();
    }

protected:
    bool filterAcceptsRow(int row, const QModelIndex& parent) const override {
        QString all;
        for (int c = 0; c < sourceModel()->columnCount(parent); ++c)
            all += sourceModel()->index(row, c, parent).data().toString() + QLatin1Char('\n');
        return std::all_of(m_words.begin(), m_words.end(),
                           [&](const QString& word) { return all.contains(word, Qt::CaseInsensitive); });
    }

private:
    QStringList m_words;
};

/// Words with room at their sides, or a coloured field round them; the row is what is selected, not a cell.
class ToneDelegate final : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;
    void setColours(PaletteName palette) { m_palette = palette; }

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        QStyleOptionViewItem bare = option;
        initStyleOption(&bare, index);
        const QString words = std::exchange(bare.text, QString());
        bare.state &= ~QStyle::State_HasFocus;
        option.widget->style()->drawControl(QStyle::CE_ItemViewItem, &bare, painter, option.widget);
        if (words.isEmpty()) return;
        painter->save();
        painter->setFont(bare.font);
        const auto tone = static_cast<Tone>(index.data(RowsModel::kToneRole).toInt());
        if (tone == Tone::Plain || tone == Tone::Quiet) {
            drawWords(*painter, bare, words, tone);
        } else {
            drawField(*painter, bare, words, tone);
        }
        painter->restore();
    }

private:
    void drawWords(QPainter& painter, const QStyleOptionViewItem& option, const QString& words,
                   Tone tone) const {
        const ThemeColours& c = themeColours(m_palette);
        const bool enabled = (option.state & QStyle::State_Enabled) != 0;
        const bool selected = (option.state & QStyle::State_Selected) != 0;
        painter.setPen(!enabled              ? c.disabledText
                       : selected            ? c.onSelected
                       : tone == Tone::Quiet ? c.quietText
                                             : c.text);
        const QRect room = option.rect.adjusted(kSide_px, 0, -kSide_px, 0);
        painter.drawText(room, int(option.displayAlignment) | Qt::TextSingleLine,
                         option.fontMetrics.elidedText(words, Qt::ElideRight, room.width()));
    }

    void drawField(QPainter& painter, const QStyleOptionViewItem& option, const QString& words,
                   Tone tone) const {
        const ThemeColours& c = themeColours(m_palette);
        const QColor behind = tone == Tone::Good ? c.running : tone == Tone::Bad ? c.alarm : c.caution;
        const QColor ink = tone == Tone::Good ? c.onRunning : tone == Tone::Bad ? c.onAlarm : c.onCaution;
        const int width_px = option.fontMetrics.horizontalAdvance(words) + 14;
        QRect field(0, 0, std::min(width_px, option.rect.width() - 4), option.fontMetrics.height() + 2);
        field.moveCenter(option.rect.center());
        if ((option.displayAlignment & Qt::AlignRight) != 0) {
            field.moveRight(option.rect.right() - 2);
        } else {
            field.moveLeft(option.rect.left() + 2);
        }
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(Qt::NoPen);
        painter.setBrush(behind);
        painter.drawRoundedRect(field, 4, 4);
        painter.setPen(ink);
        painter.drawText(field, Qt::AlignCenter, words);
    }

    PaletteName m_palette = PaletteName::Day;
};

}  // namespace

QStyledItemDelegate* toneDelegate(PaletteName palette, QObject* parent) {
    auto* const made = new ToneDelegate(parent);
    made->setColours(palette);
    return made;
}

RowsModel::RowsModel(std::vector<Column> columns, QObject* parent)
    : QAbstractTableModel(parent), m_columns(std::move(columns)) {}

void RowsModel::show(std::vector<Row> rows) {
    beginResetModel();
    m_rows = std::move(rows);
    endResetModel();
}

int RowsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int RowsModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_columns.size());
}

QVariant RowsModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) return {};
    const Row& row = m_rows[static_cast<std::size_t>(index.row())];
    const auto column = static_cast<std::size_t>(index.column());
    if (column >= row.cells.size()) return {};
    const Cell& cell = row.cells[column];
    switch (role) {
        case Qt::DisplayRole:
            return cell.text;
        case Qt::ToolTipRole:
            return cell.tip.isEmpty() ? QVariant() : cell.tip;
        case Qt::TextAlignmentRole:
            return int(Qt::AlignVCenter | (m_columns[column].number ? Qt::AlignRight : Qt::AlignLeft));
        case kOrderRole:
            return cell.order.isValid() ? cell.order : QVariant(cell.text);
        case kToneRole:
            return static_cast<int>(cell.tone);
        default:
            return {};
    }
}

QVariant RowsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || section < 0 || section >= columnCount()) return {};
    const Column& column = m_columns[static_cast<std::size_t>(section)];
    if (role == Qt::DisplayRole) return column.title;
    if (role == Qt::ToolTipRole && !column.tip.isEmpty()) return column.tip;
    if (role == Qt::TextAlignmentRole)
        return int(Qt::AlignVCenter | (column.number ? Qt::AlignRight : Qt::AlignLeft));
    return {};
}

RowsView::RowsView(const QString& name, std::vector<Column> columns, QWidget* parent)
    : QTableView(parent), m_model(new RowsModel(std::move(columns), this)), m_sorted(new Searched(this)) {
    setObjectName(name);
    m_sorted->setSourceModel(m_model);
    m_sorted->setSortRole(RowsModel::kOrderRole);
    m_sorted->setSortCaseSensitivity(Qt::CaseInsensitive);
    m_sorted->setSortLocaleAware(true);
    setModel(m_sorted);
    setItemDelegate(new ToneDelegate(this));
    setSelectionBehavior(SelectRows);
    setSelectionMode(SingleSelection);
    setEditTriggers(NoEditTriggers);
    setAlternatingRowColors(true);
    setShowGrid(false);
    setWordWrap(false);
    setTabKeyNavigation(false);
    setSortingEnabled(true);
    m_sorted->sort(-1);
    horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setSortIndicatorClearable(true);
    verticalHeader()->hide();
    verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 10);
    connect(selectionModel(), &QItemSelectionModel::selectionChanged, this, &RowsView::chosen);
    connect(this, &QTableView::doubleClicked, this, [this](const QModelIndex& index) {
        Q_EMIT opened(m_model->idOf(m_sorted->mapToSource(index).row()));
    });
}

void RowsView::show(std::vector<Row> rows) {
    const std::vector<std::int64_t> before = selectedIds();
    m_model->show(std::move(rows));
    fitColumns();
    if (before.empty()) return;
    QItemSelection again;
    for (int row = 0; row < m_sorted->rowCount(); ++row) {
        const std::int64_t id = m_model->idOf(m_sorted->mapToSource(m_sorted->index(row, 0)).row());
        if (std::find(before.begin(), before.end(), id) != before.end())
            again.select(m_sorted->index(row, 0), m_sorted->index(row, m_sorted->columnCount() - 1));
    }
    selectionModel()->select(again, QItemSelectionModel::ClearAndSelect);
    if (again.isEmpty()) Q_EMIT chosen();  // a reset model tells nobody
}

void RowsView::setEmptyText(const QString& text) {
    m_emptyText = text;
    viewport()->update();
}

void RowsView::setSearch(const QString& words) {
    static_cast<Searched*>(m_sorted)->setWords(words.split(QLatin1Char(' '), Qt::SkipEmptyParts));
}

void RowsView::setColours(PaletteName palette) {
    static_cast<ToneDelegate*>(itemDelegate())->setColours(palette);
    viewport()->update();
}

int RowsView::shownRows() const { return m_sorted->rowCount(); }

std::vector<std::int64_t> RowsView::shownIds() const {
    std::vector<std::int64_t> ids;
    for (int row = 0; row < m_sorted->rowCount(); ++row)
        ids.push_back(m_model->idOf(m_sorted->mapToSource(m_sorted->index(row, 0)).row()));
    return ids;
}

std::vector<std::int64_t> RowsView::selectedIds() const {
    std::vector<std::int64_t> ids;
    for (const QModelIndex& index : selectionModel()->selectedRows())
        ids.push_back(m_model->idOf(m_sorted->mapToSource(index).row()));
    return ids;
}

std::int64_t RowsView::selectedId() const {
    const auto ids = selectedIds();
    return ids.size() == 1 ? ids.front() : 0;
}

void RowsView::select(std::int64_t id) {
    for (int row = 0; row < m_sorted->rowCount(); ++row) {
        if (m_model->idOf(m_sorted->mapToSource(m_sorted->index(row, 0)).row()) != id) continue;
        selectRow(row);
        scrollTo(m_sorted->index(row, 0));
        return;
    }
    clearSelection();
}

void RowsView::paintEvent(QPaintEvent* event) {
    QTableView::paintEvent(event);
    if (m_sorted->rowCount() > 0 || m_emptyText.isEmpty()) return;
    QPainter painter(viewport());
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(viewport()->rect().adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap,
                     m_emptyText);
}

void RowsView::resizeEvent(QResizeEvent* event) {
    QTableView::resizeEvent(event);
    fitColumns();
}

void RowsView::keyPressEvent(QKeyEvent* event) {
    if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && selectedId() != 0)
        return Q_EMIT opened(selectedId());
    QTableView::keyPressEvent(event);
}

/// As wide as their words, and what is left over to those that stretch; not over what a person has chosen.
void RowsView::fitColumns() {
    if (property(kept::kWidthsChosen).toBool()) return;
    setProperty(kept::kFitting, true);
    const auto& columns = m_model->columns();
    const int count = static_cast<int>(columns.size());
    std::vector<int> wanted(columns.size());
    int sum_px = 0, stretching = 0;
    for (int c = 0; c < count; ++c) {
        const auto i = static_cast<std::size_t>(c);
        int width_px = horizontalHeader()->fontMetrics().horizontalAdvance(columns[i].title) + kPadding_px;
        const int looked = std::min(m_model->rowCount(), 200);
        for (int r = 0; r < looked; ++r) {
            const QString words = m_model->index(r, c).data().toString();
            width_px = std::max(width_px, fontMetrics().horizontalAdvance(words) + kPadding_px);
        }
        wanted[i] = std::min(width_px, columns[i].stretch ? 260 : 240);
        sum_px += wanted[i];
        stretching += columns[i].stretch ? 1 : 0;
    }
    const int spare_px = viewport()->width() - sum_px;
    for (int c = 0; c < count; ++c) {
        const auto i = static_cast<std::size_t>(c);
        const bool gets = columns[i].stretch && stretching > 0;
        // Too narrow a window takes from the columns that stretch, too, down to a word.
        setColumnWidth(c, gets ? std::max(90, wanted[i] + spare_px / stretching) : wanted[i]);
    }
    setProperty(kept::kFitting, false);
}

}  // namespace sagara::ui::roster
