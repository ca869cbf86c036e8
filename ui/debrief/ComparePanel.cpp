#include "ui/debrief/ComparePanel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "ui/theme/ThemeColours.h"

namespace sagara::ui {

ComparePanel::ComparePanel(QWidget* parent)
    : QWidget(parent),
      m_about(new QLabel(this)),
      m_legend(new QLabel(this)),
      m_table(new QTableWidget(0, 4, this)),
      m_sailOn(new QPushButton(tr("Sail on"), this)) {
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(6, 6, 6, 6);
    layout->setSpacing(4);
    m_about->setWordWrap(true);
    m_about->setObjectName(QStringLiteral("compare-about"));
    layout->addWidget(m_about);
    layout->addWidget(m_legend);
    m_table->setObjectName(QStringLiteral("compare-table"));
    m_table->setHorizontalHeaderLabels({tr("From then on"), tr("Sailed"), tr("What if"), tr("Difference")});
    m_table->verticalHeader()->hide();
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setWordWrap(true);
    m_table->setToolTip(tr("Click a line to go to its moment"));
    m_table->setShowGrid(false);
    m_table->setAlternatingRowColors(true);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    layout->addWidget(m_table, 1);
    connect(m_table, &QTableWidget::cellClicked, this, [this](int row) {
        const QVariant time = m_table->item(row, 0)->data(Qt::UserRole);
        if (time.isValid()) Q_EMIT picked({time.toLongLong()});
    });
    m_sailOn->setObjectName(QStringLiteral("sail-on"));
    m_sailOn->setToolTip(tr("Go on with the what-if run where it was frozen"));
    connect(m_sailOn, &QPushButton::clicked, this, &ComparePanel::sailOnWanted);
    auto* const close = new QPushButton(tr("End what if"), this);
    close->setObjectName(QStringLiteral("compare-close"));
    close->setToolTip(tr("End and file the what-if run, and show the recording alone"));
    connect(close, &QPushButton::clicked, this, &ComparePanel::closeWanted);
    auto* const buttons = new QHBoxLayout;
    buttons->addWidget(m_sailOn, 1);
    buttons->addWidget(close, 1);
    layout->addLayout(buttons);
}

void ComparePanel::setColours(PaletteName name) {
    const ThemeColours& c = themeColours(name);
    m_legend->setText(
        QStringLiteral("<span style='color:%1'>━━</span> %2 &nbsp; <span style='color:%3'>━━</span> %4")
            .arg(c.series[0].name(), tr("sailed"), c.series[1].name(), tr("what if")));
}

void ComparePanel::show(const std::vector<ComparisonRow>& rows, const QString& about, bool maySailOn) {
    m_about->setText(about);
    m_sailOn->setEnabled(maySailOn);
    m_table->setRowCount(static_cast<int>(rows.size()));
    for (int i = 0; i < m_table->rowCount(); ++i) {
        const ComparisonRow& r = rows[static_cast<std::size_t>(i)];
        const QString texts[] = {r.name, r.sailed, r.whatIf, r.difference};
        for (int column = 0; column < 4; ++column) {
            auto* const item = new QTableWidgetItem(texts[column]);
            if (column > 0) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            item->setToolTip(texts[column]);
            m_table->setItem(i, column, item);
        }
        if (r.moment)
            m_table->item(i, 0)->setData(Qt::UserRole, QVariant::fromValue<qlonglong>(r.moment->us));
    }
}

}  // namespace sagara::ui
