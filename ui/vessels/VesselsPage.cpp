#include "ui/vessels/VesselsPage.h"

#include <QCheckBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QShortcut>
#include <QSplitter>
#include <QTabWidget>
#include <QTableWidget>
#include <QVBoxLayout>

#include "core/base/Units.h"
#include "ui/theme/Theme.h"
#include "ui/theme/ThemeColours.h"
#include "ui/vessels/DocumentTree.h"
#include "ui/vessels/SectionsView.h"
#include "ui/vessels/TrialsPanel.h"
#include "ui/vessels/WrongWords.h"

namespace sagara::ui {
namespace {

QString q(const std::string& text) { return QString::fromStdString(text); }

QString iconOf(const std::string& type) {
    const auto has = [&](const char* word) { return type.find(word) != std::string::npos; };
    if (has("tanker")) return QStringLiteral("ship-tanker");
    if (has("bulk") || has("cargo")) return QStringLiteral("ship-bulkcarrier");
    if (has("container")) return QStringLiteral("ship-container");
    if (has("fish")) return QStringLiteral("ship-fishing");
    if (has("ferry") || has("passenger")) return QStringLiteral("ship-passenger");
    if (has("tug")) return QStringLiteral("ship-tugboat");
    if (has("yacht")) return QStringLiteral("ship-yacht");
    if (has("fast")) return QStringLiteral("ship-highspeed");
    if (has("patrol") || has("navy")) return QStringLiteral("ship-navy");
    return QStringLiteral("ship");
}

}  // namespace

VesselsPage::VesselsPage(VesselLibrary& library, StageFor stageFor, Today today, QWidget* parent)
    : Page(parent), m_library(library), m_stageFor(std::move(stageFor)), m_today(std::move(today)) {
    setWindowTitle(tr("Vessels"));
    setObjectName(QStringLiteral("vesselsPage"));
    auto* const splitter = new QSplitter(Qt::Horizontal, this);
    splitter->addWidget(listSide());
    splitter->addWidget(detailSide());
    splitter->setStretchFactor(1, 1);
    splitter->setSizes({290, 990});
    splitter->setChildrenCollapsible(false);
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(10, 10, 10, 10);
    layout->addWidget(splitter, 1);
    layout->addWidget(m_message);

    connect(m_search, &QLineEdit::textChanged, this, [this] { fillList(); });
    connect(m_showRetired, &QCheckBox::toggled, this, [this] { fillList(); });
    connect(m_list, &QListWidget::currentRowChanged, this, [this] { showChosen(); });
    connect(m_new, &QPushButton::clicked, this, &VesselsPage::openNew);
    connect(m_edit, &QPushButton::clicked, this, &VesselsPage::openEditor);
    connect(m_model, &QPushButton::clicked, this, &VesselsPage::openModel);
    connect(m_copy, &QPushButton::clicked, this, &VesselsPage::duplicate);
    connect(m_retire, &QPushButton::clicked, this, &VesselsPage::retireOrRestore);
    connect(m_back, &QPushButton::clicked, this, &VesselsPage::backToShipped);
    connect(m_import, &QPushButton::clicked, this, [this] {
        const QString file = QFileDialog::getOpenFileName(this, tr("Import a vessel"), QString(),
                                                          tr("Vessels (*.json);;All files (*)"));
        if (!file.isEmpty()) tell(importFrom(file.toStdString()));
    });
    connect(m_export, &QPushButton::clicked, this, [this] {
        const QString file = QFileDialog::getSaveFileName(
            this, tr("Export the vessel"), q(chosen()) + QStringLiteral(".json"), tr("Vessels (*.json)"));
        if (!file.isEmpty()) tell(exportTo(file.toStdString()));
    });
    connect(m_card, &QPushButton::clicked, this, [this] {
        const QString file = QFileDialog::getSaveFileName(
            this, tr("Pilot card"), q(chosen()) + QStringLiteral("-pilot-card.pdf"), tr("PDF (*.pdf)"));
        if (!file.isEmpty()) writePilotCard(file);
    });
    connect(m_trials, &TrialsPanel::finished, this, [this] {
        if (!m_cardWanted.isEmpty()) writePilotCard(std::exchange(m_cardWanted, {}));
    });
    auto* const find = new QShortcut(QKeySequence::Find, this);
    connect(find, &QShortcut::activated, m_search, [this] { m_search->setFocus(); });
    fillList();
    if (!m_library.trouble().empty()) tell(m_library.trouble());
}

VesselsPage::~VesselsPage() = default;

QPushButton* VesselsPage::button(const QString& text, const char* name, const char* icon,
                                 const QString& tip) {
    auto* const b = new QPushButton(text, this);
    b->setObjectName(QString::fromLatin1(name));
    b->setToolTip(tip);
    m_icons.emplace_back(b, QString::fromLatin1(icon));
    return b;
}

QWidget* VesselsPage::listSide() {
    auto* const side = new QWidget(this);
    auto* const layout = new QVBoxLayout(side);
    layout->setContentsMargins(0, 0, 6, 0);
    m_search = new QLineEdit(side);
    m_search->setObjectName(QStringLiteral("search"));
    m_search->setPlaceholderText(tr("Search by name or id"));
    m_search->setClearButtonEnabled(true);
    m_search->setToolTip(tr("Part of a name or id (Ctrl+F)"));
    m_list = new QListWidget(side);
    m_list->setObjectName(QStringLiteral("vessels"));
    m_list->setAlternatingRowColors(true);
    m_list->setIconSize(QSize(28, 28));
    m_list->setWordWrap(true);
    m_empty = new QLabel(side);
    m_empty->setWordWrap(true);
    m_empty->setAlignment(Qt::AlignCenter);
    m_showRetired = new QCheckBox(tr("Show deleted vessels"), side);
    m_showRetired->setObjectName(QStringLiteral("showRetired"));
    m_showRetired->setToolTip(tr("Deleted vessels are kept for old recordings and can be restored"));
    m_new = button(tr("New from particulars…"), "new", "ship",
                   tr("A new vessel from length, beam, draught, speed and power (Ctrl+N)"));
    m_new->setProperty("primary", true);
    m_new->setShortcut(QKeySequence::New);
    m_import = button(tr("Import…"), "import", "file-upload-google",
                      tr("Takes in a vessel file from another school"));
    layout->addWidget(m_search);
    layout->addWidget(m_list, 1);
    layout->addWidget(m_empty, 1);
    layout->addWidget(m_showRetired);
    layout->addWidget(m_new);
    layout->addWidget(m_import);
    return side;
}

QWidget* VesselsPage::detailSide() {
    auto* const side = new QWidget(this);
    m_title = new QLabel(side);
    m_title->setObjectName(QStringLiteral("title"));
    QFont font = m_title->font();
    font.setPointSizeF(1.5 * font.pointSizeF());
    font.setBold(true);
    m_title->setFont(font);
    m_title->setWordWrap(true);
    m_subtitle = new QLabel(side);
    m_subtitle->setWordWrap(true);
    m_message = new QLabel(this);
    m_message->setObjectName(QStringLiteral("message"));
    m_message->setWordWrap(true);
    m_message->hide();

    m_edit =
        button(tr("Edit…"), "edit", "settings-iec", tr("Every number of the document, checked as you type"));
    m_copy = button(tr("Duplicate…"), "duplicate", "ship", tr("A copy under another id, the school's own"));
    m_model = button(tr("3D model…"), "model", "camera-on",
                     tr("Attach a model file: scale, axes, waterline, lights"));
    m_export = button(tr("Export…"), "export", "file-download-google",
                      tr("One file with the vessel and her 3D model"));
    m_card = button(tr("Pilot card…"), "pilotCard", "print",
                    tr("PDF after IMO A.601(15); runs the trials first where they have not been"));
    m_back = button(tr("Back to the shipped one"), "backToShipped", "ship",
                    tr("Puts the vessel as Sagara ships it in place of the school's own changes"));
    m_retire = button(tr("Delete"), "retire", "target-cancel-iec", QString());
    auto* const actions = new QHBoxLayout;
    for (QPushButton* b : {m_edit, m_copy, m_model, m_export, m_card, m_back, m_retire})
        actions->addWidget(b);
    actions->addStretch(1);

    m_tabs = new QTabWidget(side);
    m_tabs->setObjectName(QStringLiteral("tabs"));
    m_facts = new QTableWidget(0, 2, side);
    m_facts->setObjectName(QStringLiteral("facts"));
    m_facts->horizontalHeader()->hide();
    m_facts->verticalHeader()->hide();
    m_facts->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    m_facts->horizontalHeader()->setStretchLastSection(true);
    m_facts->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_facts->setSelectionMode(QAbstractItemView::NoSelection);
    m_facts->setAlternatingRowColors(true);
    m_facts->setShowGrid(false);
    m_facts->setWordWrap(false);
    m_facts->verticalHeader()->setDefaultSectionSize(25);
    m_facts->setMinimumWidth(300);
    m_view = new ShipView(m_stageFor, side);
    m_sections = new SectionsView(side);
    auto* const ship = new QWidget(side);
    auto* const shipLayout = new QHBoxLayout(ship);
    auto* const pictures = new QVBoxLayout;
    pictures->addWidget(m_view, 3);
    pictures->addWidget(m_sections, 3);
    shipLayout->addWidget(m_facts, 2);
    shipLayout->addLayout(pictures, 3);
    m_tree = new DocumentTree(DocumentTree::Use::Read, side);
    m_trials = new TrialsPanel(side);
    m_tabs->addTab(ship, tr("Ship"));
    m_tabs->addTab(m_tree, tr("Data and sources"));
    m_tabs->addTab(m_trials, tr("Test"));

    auto* const layout = new QVBoxLayout(side);
    layout->setContentsMargins(6, 0, 0, 0);
    layout->addWidget(m_title);
    layout->addWidget(m_subtitle);
    layout->addLayout(actions);
    layout->addWidget(m_tabs, 1);
    return side;
}

void VesselsPage::setColours(PaletteName name) {
    m_colours = name;
    for (const auto& [b, icon] : m_icons) b->setIcon(themedIcon(icon, name));
    const QIcon onPrimary = themedIcon(QStringLiteral("ship"), name);
    m_new->setIcon(QIcon(onPrimary.pixmap(24, QIcon::Selected)));
    m_sections->setColours(name);
    m_tree->setColours(name);
    m_trials->setColours(name);
    QPalette colours = m_message->palette();
    colours.setColor(QPalette::WindowText, wrongWords(name));
    m_message->setPalette(colours);
    fillList();
    m_facts->setRowCount(0);
    if (m_vessel) showFacts(*m_vessel);
}

bool VesselsPage::mayLeave() {
    m_trials->cancel();
    return true;
}

void VesselsPage::fillList() {
    const std::string before = chosen();
    m_entries = m_library.all();
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    const QString wanted = m_search->text().trimmed();
    for (const VesselEntry& entry : m_entries) {
        if (entry.retired && !m_showRetired->isChecked()) continue;
        if (!q(entry.name).contains(wanted, Qt::CaseInsensitive) &&
            !q(entry.id).contains(wanted, Qt::CaseInsensitive))
            continue;
        const auto vessel = core::loadVessel(entry.id, m_library.text(entry.id));
        const QString whose = entry.retired   ? tr("deleted")
                              : entry.shipped ? tr("shipped")
                                              : tr("the school's own");
        auto* const item =
            new QListWidgetItem(themedIcon(vessel ? iconOf(vessel->type) : QStringLiteral("ship"), m_colours),
                                QStringLiteral("%1\n%2 · %3").arg(q(entry.name), q(entry.id), whose), m_list);
        item->setData(Qt::UserRole, q(entry.id));
        if (entry.retired) item->setForeground(themeColours(m_colours).disabledText);
        if (entry.id == before) m_list->setCurrentItem(item);
    }
    const bool none = m_list->count() == 0;
    m_list->setVisible(!none);
    m_empty->setVisible(none);
    m_empty->setText(wanted.isEmpty() ? tr("No vessels yet. Make one from her particulars, or import a file.")
                                      : tr("No vessel has “%1” in its name or id.").arg(wanted));
    if (m_list->currentRow() < 0 && !none) m_list->setCurrentRow(0);
    if (chosen() != before || !m_vessel)
        showChosen();
    else
        showActions();
}

std::string VesselsPage::chosen() const {
    return m_list->currentItem() ? m_list->currentItem()->data(Qt::UserRole).toString().toStdString()
                                 : std::string();
}

bool VesselsPage::choose(const std::string& id) {
    for (int i = 0; i < m_list->count(); ++i) {
        if (m_list->item(i)->data(Qt::UserRole).toString() != q(id)) continue;
        m_list->setCurrentRow(i);
        return true;
    }
    return false;
}

void VesselsPage::showChosen() {
    const std::string id = chosen();
    m_vessel.reset();
    m_text = id.empty() ? std::string() : m_library.text(id);
    QString trouble;
    if (!id.empty()) {
        const auto vessel = core::loadVessel(id, m_text);
        if (vessel)
            m_vessel = *vessel;
        else
            trouble = q(vessel.error().text());
    }
    m_title->setText(m_vessel ? q(m_vessel->name) : id.empty() ? tr("No vessel chosen") : q(id));
    m_subtitle->setText(!trouble.isEmpty() ? trouble
                        : m_vessel         ? QString()
                                           : tr("Choose a vessel on the left, or make a new one."));
    m_subtitle->setVisible(!m_subtitle->text().isEmpty());
    m_facts->setRowCount(0);
    if (m_vessel) showFacts(*m_vessel);
    m_sections->setHull(m_vessel ? std::optional(m_vessel->hull) : std::nullopt);
    m_tree->setDocument(m_text.empty() ? "{}" : m_text);
    m_tree->expandToDepth(0);
    m_trials->setVessel(m_vessel);
    m_view->setVessel(m_vessel);
    m_message->hide();
    showActions();
}

void VesselsPage::showFacts(const core::Vessel& v) {
    const auto row = [&](const QString& label, const QString& value) {
        const int at = m_facts->rowCount();
        m_facts->insertRow(at);
        auto* const name = new QTableWidgetItem(label);
        name->setForeground(themeColours(m_colours).quietText);
        m_facts->setItem(at, 0, name);
        auto* const item = new QTableWidgetItem(value);
        item->setToolTip(value);
        m_facts->setItem(at, 1, item);
    };
    const auto number = [](double value, int decimals) { return QString::number(value, 'f', decimals); };
    const core::Hull& h = v.hull;
    row(tr("Type"), q(v.type));
    row(tr("Length overall"), tr("%1 m").arg(number(h.lengthOverall_m, 1)));
    row(tr("Length between perp."), tr("%1 m").arg(number(h.lengthBp_m, 1)));
    row(tr("Beam"), tr("%1 m").arg(number(h.beam_m, 2)));
    row(tr("Draught"), tr("%1 m").arg(number(h.draught_m, 2)));
    row(tr("Displacement"), tr("%1 t").arg(number(h.mass_kg() / 1000.0, 0)));
    row(tr("Block coefficient"), number(h.blockCoefficient(), 3));
    row(tr("GM"), tr("%1 m").arg(number(h.metacentricHeight_m, 2)));
    row(tr("Propellers"),
        tr("%1, %2 m").arg(v.propulsion.units.size()).arg(number(v.propulsion.units[0].diameter_m, 2)));
    row(tr("Full ahead"), tr("%1 rpm").arg(number(v.propulsion.telegraph_rps.back() / core::kRpm_rps, 0)));
    row(tr("Rudders"),
        tr("%1, %2 m² each, to %3°")
            .arg(v.steering.rudders.size())
            .arg(number(v.steering.areaEach_m2, 1), number(v.steering.limit_rad / core::kDegree_rad, 0)));
    row(tr("Wind area, side"), tr("%1 m²").arg(number(v.windage.lateralArea_m2, 0)));
    row(tr("Anchors"), tr("%1").arg(v.groundTackle.anchors.size()));
    row(tr("Eye height"), tr("%1 m").arg(number(v.bridgeEyeHeight_m, 1)));
    const auto quality = [&](const QString& group, const core::Provenance& p) {
        row(group, tr("%1: %2").arg(QString::fromLatin1(core::qualityName(p.quality)), q(p.source)));
    };
    quality(tr("Hull data"), h.provenance);
    for (const core::NamedModel& m : v.models) quality(tr("Ship model %1").arg(q(m.name)), m.provenance);
    quality(tr("Propulsion data"), v.propulsion.provenance);
    quality(tr("Steering data"), v.steering.provenance);
    quality(tr("Windage data"), v.windage.provenance);
}

void VesselsPage::showActions() {
    const std::string id = chosen();
    const auto it =
        std::find_if(m_entries.begin(), m_entries.end(), [&](const auto& e) { return e.id == id; });
    const bool any = it != m_entries.end(), retired = any && it->retired,
               writable = m_library.trouble().empty();
    m_new->setEnabled(writable);
    m_import->setEnabled(writable);
    m_edit->setEnabled(any && writable && !retired);
    m_copy->setEnabled(any && writable && m_vessel.has_value());
    m_model->setEnabled(any && writable && !retired && m_vessel.has_value());
    m_export->setEnabled(any);
    m_card->setEnabled(m_vessel.has_value());
    m_back->setVisible(any && !it->shipped && m_library.isShippedToo(id));
    m_back->setEnabled(writable);
    m_retire->setEnabled(any && writable);
    m_retire->setText(retired ? tr("Restore") : tr("Delete"));
    m_retire->setToolTip(
        retired ? tr("Puts the vessel back into the lists")
                : tr("Refused while a scenario uses her. Old recordings still replay; she can be restored."));
}

void VesselsPage::tell(const Trouble& trouble) {
    m_message->setVisible(trouble.has_value() && !trouble->empty());
    if (trouble) m_message->setText(q(*trouble));
}

}  // namespace sagara::ui
