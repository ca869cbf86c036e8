#include "app/station/KeptTables.h"

#include <QHeaderView>
#include <QPointer>
#include <QTableView>
#include <QTimer>
#include <QTreeView>

#include "ui/theme/KeptTables.h"

namespace sagara::station {
namespace {

/// Header of a table or tree; null: another view, or one whose header is not shown.
QHeaderView* headerOf(QAbstractItemView* view) {
    QHeaderView* header = nullptr;
    if (auto* const table = qobject_cast<QTableView*>(view)) header = table->horizontalHeader();
    if (auto* const tree = qobject_cast<QTreeView*>(view)) header = tree->header();
    return header != nullptr && !header->isHidden() ? header : nullptr;
}

/// "SECTION,ORDER" of the sorting, then the widths: "2,1,140,80,95"; without these, they were not chosen.
QString textOf(const QHeaderView& header, bool withWidths) {
    QStringList numbers{QString::number(header.sortIndicatorSection()),
                        QString::number(static_cast<int>(header.sortIndicatorOrder()))};
    for (int c = 0; withWidths && c < header.count(); ++c) numbers += QString::number(header.sectionSize(c));
    return numbers.join(QLatin1Char(','));
}

class KeptTables final : public QObject {
public:
    KeptTables(ui::Page& page, std::unique_ptr<ui::SettingsStore> settings)
        : QObject(&page), m_settings(std::move(settings)) {
        int unnamed = 0;
        for (auto* const view : page.findChildren<QAbstractItemView*>()) {
            QHeaderView* const header = headerOf(view);
            if (header == nullptr) continue;
            const QString name =
                view->objectName().isEmpty() ? QString::number(++unnamed) : view->objectName();
            m_tables.push_back({QStringLiteral("ui.table.%1.%2").arg(page.helpTopic(), name).toStdString(),
                                view,
                                header,
                                {},
                                {}});
        }
        // Pages give their columns a width when they are shown.
        QTimer::singleShot(0, this, [this] {
            for (std::size_t i = 0; i < m_tables.size(); ++i) restore(i);
        });
    }
    ~KeptTables() override {  // the tables may have gone before
        for (const Table& table : m_tables)
            if (table.now != table.before) m_settings->put(table.key, table.now.toStdString());
    }

private:
    struct Table {
        std::string key;
        QPointer<QAbstractItemView> view;
        QPointer<QHeaderView> header;
        QString before, now;
    };

    void restore(std::size_t i) {
        Table& table = m_tables[i];
        if (!table.header) return;
        if (const auto kept = m_settings->get(table.key))
            give(table, QString::fromStdString(*kept).split(QLatin1Char(',')));
        table.before = table.now = text(table);
        connect(table.header, &QHeaderView::sectionResized, this, [this, i] {
            Table& resized = m_tables[i];
            if (resized.view->property(ui::kept::kFitting).toBool()) return;
            resized.view->setProperty(ui::kept::kWidthsChosen, true);
            resized.now = text(resized);
        });
        connect(table.header, &QHeaderView::sortIndicatorChanged, this,
                [this, i] { m_tables[i].now = text(m_tables[i]); });
    }
    static QString text(const Table& table) {
        return textOf(*table.header, table.view->property(ui::kept::kWidthsChosen).toBool());
    }
    static void give(const Table& table, const QStringList& numbers) {
        QHeaderView& header = *table.header;
        if (numbers.size() < 2) return;
        const int section = numbers[0].toInt();
        if (section < header.count() && header.sectionsClickable())
            header.setSortIndicator(section, static_cast<Qt::SortOrder>(numbers[1].toInt()));
        if (numbers.size() != header.count() + 2) return;
        table.view->setProperty(ui::kept::kWidthsChosen, true);
        for (int c = 0; c < header.count(); ++c)
            if (header.sectionResizeMode(c) == QHeaderView::Interactive && numbers[c + 2].toInt() > 0)
                header.resizeSection(c, numbers[c + 2].toInt());
    }

    std::unique_ptr<ui::SettingsStore> m_settings;
    std::vector<Table> m_tables;
};

}  // namespace

void keepTables(ui::Page& page, std::unique_ptr<ui::SettingsStore> settings) {
    new KeptTables(page, std::move(settings));
}

}  // namespace sagara::station
