#include "ui/settings/DataSection.h"

#include <QApplication>
#include <QClipboard>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace sagara::ui {

DataSection::DataSection(const DataPlaces& places, QWidget* parent)
    : Section(tr("Data"), QStringLiteral("save-proposal"), parent) {
    auto* const group = new QGroupBox(tr("Where things are kept"), this);
    auto* const form = new QFormLayout(group);
    const auto path = [group, form](const QString& title, const QString& text, const char* name) {
        auto* const label = new QLabel(text, group);
        label->setObjectName(QString::fromLatin1(name));
        label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        label->setWordWrap(true);
        form->addRow(title, label);
    };
    path(tr("Data folder"), places.folder, "data-folder");
    path(tr("Database"), places.database, "data-database");
    path(tr("Recordings"), places.recordings, "data-recordings");
    QLabel* const trouble = complaint("data-trouble");
    form->addRow(trouble);
    if (!places.databaseTrouble.isEmpty())
        say(trouble, tr("The database cannot be used: %1. Exercises run; they are filed when it is back.")
                         .arg(places.databaseTrouble));
    auto* const copy = new QPushButton(tr("Copy path of the data folder"), this);
    copy->setObjectName(QStringLiteral("data-copy"));
    copy->setToolTip(tr("To the clipboard"));
    const QString folder = places.folder;
    connect(copy, &QPushButton::clicked, this, [folder] { QApplication::clipboard()->setText(folder); });
    auto* const row = new QHBoxLayout;  // a form would stretch it
    row->addWidget(copy);
    row->addStretch();
    form->addRow(row);
    auto* const layout = new QVBoxLayout(this);
    layout->addWidget(group);
    layout->addWidget(note(tr("Another folder is chosen when Sagara is started: sagara --data FOLDER.")));
    layout->addStretch();
}

}  // namespace sagara::ui
