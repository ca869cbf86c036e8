#include "ui/editor/ProblemList.h"

#include <QLabel>
#include <QListWidget>
#include <QVBoxLayout>

#include "ui/editor/ScenarioFields.h"
#include "ui/theme/ThemeColours.h"

namespace sagara::ui::editor {

ProblemList::ProblemList(const std::vector<Section>& sections, QWidget* parent)
    : QWidget(parent), m_sections(sections), m_summary(new QLabel(this)), m_list(new QListWidget(this)) {
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_summary);
    layout->addWidget(m_list);
    m_summary->setObjectName(QStringLiteral("problem-summary"));
    m_summary->setContentsMargins(8, 4, 8, 4);
    m_list->setObjectName(QStringLiteral("problems"));
    m_list->setToolTip(words("Click a problem, or press Enter on it, to go to its field"));
    m_list->setFixedHeight(104);
    m_list->setWordWrap(true);
    m_list->hide();
    const auto follow = [this](const QListWidgetItem* item) {
        if (item) Q_EMIT chosen(item->data(Qt::UserRole).toString().toStdString());
    };
    connect(m_list, &QListWidget::itemClicked, this, follow);
    connect(m_list, &QListWidget::itemActivated, this, follow);
    setChecking();
}

void ProblemList::setChecking() { m_summary->setText(words("Checking …")); }

void ProblemList::show(const std::vector<core::config::Problem>& problems) {
    m_any = !problems.empty();
    m_summary->setText(!m_any                 ? words("✓ No problems: the scenario can be run.")
                       : problems.size() == 1 ? words("▲ 1 problem. Until it is mended the scenario cannot be run.")
                                              : words("▲ %1 problems. Until they are mended the scenario cannot be run.")
                                                    .arg(problems.size()));
    setColours(m_colours);
    m_list->setVisible(m_any);
    const QString last = m_list->currentItem() ? m_list->currentItem()->text() : QString();
    m_list->clear();
    for (const auto& p : problems) {
        QString where;
        for (const Section& s : m_sections)
            if (where.isEmpty() && !p.path.empty() && s.holds(p.path)) where = s.title + QStringLiteral(" – ");
        QString text = where + QString::fromStdString(p.path + (p.path.empty() ? "" : " ") + p.found);
        if (!p.expected.empty()) text += words("; expected %1").arg(QString::fromStdString(p.expected));
        auto* const item = new QListWidgetItem(text, m_list);
        item->setData(Qt::UserRole, QString::fromStdString(p.path));
        if (text == last) m_list->setCurrentItem(item);
    }
}

void ProblemList::setColours(PaletteName colours) {
    m_colours = colours;
    const ThemeColours& c = themeColours(colours);
    const QColor back = m_any ? c.caution : c.section, text = m_any ? c.onCaution : c.text;
    m_summary->setStyleSheet(QStringLiteral("QLabel { background: %1; color: %2; }").arg(back.name(), text.name()));
}

}  // namespace sagara::ui::editor
