#include "ui/roster/AssessorForm.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/roster/Field.h"
#include "ui/roster/RosterTexts.h"

namespace sagara::ui::roster {
namespace {

constexpr int kLongestComment = 4000, kLongestReason = 1000;

QPlainTextEdit* textEdit(const char* name, const QString& accepted, QWidget* parent) {
    auto* const edit = new QPlainTextEdit(parent);
    edit->setObjectName(QLatin1String(name));
    edit->setPlaceholderText(accepted);
    edit->setTabChangesFocus(true);
    return edit;
}

QString lengthFault(const QString& words, int longest) {
    const auto length = words.toUcs4().size();
    if (length <= longest) return {};
    return AssessorForm::tr("%1 characters, expected up to %2").arg(length).arg(longest);
}

}  // namespace

AssessorForm::AssessorForm(QWidget* parent)
    : QWidget(parent),
      m_comment(textEdit("assessor-comment", tr("What the trainee did well, what is to be practised"), this)),
      m_reason(textEdit("assessor-reason", tr("Why the automatic result is overruled"), this)),
      m_overrule(new QCheckBox(tr("&Overrule the automatic result"), this)),
      m_overruling(new QWidget(this)),
      m_score(new QDoubleSpinBox(this)),
      m_passed(new QComboBox(this)),
      m_by(new QComboBox(this)),
      m_commentNote(new FieldNote(this)),
      m_reasonNote(new FieldNote(this)),
      m_byNote(new FieldNote(this)),
      m_trouble(new FieldNote(this)),
      m_state(hint({}, this)),
      m_signing(new QWidget(this)),
      m_save(new QPushButton(tr("Save the draft"), this)),
      m_sign(new QPushButton(tr("Sign off"), this)) {
    m_comment->setToolTip(tr("Up to %1 characters; printed on the report").arg(kLongestComment));
    m_reason->setToolTip(tr("Up to %1 characters; printed on the report").arg(kLongestReason));
    m_reason->setFixedHeight(4 * fontMetrics().lineSpacing() + 14);
    m_overrule->setObjectName(QStringLiteral("overrule"));
    m_overrule->setToolTip(tr("Puts a score and a result of your own in place of the automatic ones"));
    m_score->setObjectName(QStringLiteral("overruled-score"));
    m_score->setRange(0.0, 100.0);
    m_score->setDecimals(1);
    m_score->setSuffix(tr(" of 100"));
    m_score->setToolTip(tr("0 to 100 points"));
    m_passed->setObjectName(QStringLiteral("overruled-passed"));
    m_passed->addItem(tr("Passed"), true);
    m_passed->addItem(tr("Not passed"), false);
    m_passed->setToolTip(tr("Whether the run is a pass"));
    m_by->setObjectName(QStringLiteral("signed-by"));
    m_by->setPlaceholderText(tr("Choose who signs"));
    m_by->setToolTip(tr("Trainers and administrators of the roster"));
    m_state->setObjectName(QStringLiteral("assessment-state"));
    m_save->setObjectName(QStringLiteral("assessment-save"));
    m_save->setToolTip(tr("Keeps comment and overruling; they can still be changed (Ctrl+S)"));
    m_save->setShortcut(QKeySequence::Save);
    m_sign->setObjectName(QStringLiteral("sign-off"));
    m_sign->setProperty("primary", true);
    m_sign->setToolTip(tr("Keeps it for good: comment, result and grade cannot be changed afterwards"));

    auto* const inside = new QFormLayout(m_overruling);
    inside->setContentsMargins(20, 0, 0, 0);
    inside->addRow(tr("S&core"), m_score);
    inside->addRow(tr("&Result"), m_passed);
    inside->addRow(tr("R&eason"), m_reason);
    inside->addRow(QString(), m_reasonNote);
    auto* const signing = new QFormLayout(m_signing);
    signing->setContentsMargins(0, 0, 0, 0);
    signing->addRow(tr("Signed off &by"), m_by);
    signing->addRow(QString(), m_byNote);
    auto* const doing = new QHBoxLayout;
    doing->addWidget(m_save);
    doing->addWidget(m_sign, 1);
    auto* const layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(heading(tr("Assessor"), 1.2, this));
    layout->addWidget(m_state);
    layout->addWidget(m_comment, 1);
    layout->addWidget(m_commentNote);
    layout->addWidget(m_overrule);
    layout->addWidget(m_overruling);
    layout->addSpacing(8);
    layout->addWidget(m_signing);
    layout->addWidget(m_trouble);
    layout->addLayout(doing);

    connect(m_comment, &QPlainTextEdit::textChanged, this, &AssessorForm::check);
    connect(m_reason, &QPlainTextEdit::textChanged, this, &AssessorForm::check);
    connect(m_overrule, &QCheckBox::toggled, this, &AssessorForm::check);
    connect(m_score, &QDoubleSpinBox::valueChanged, this, &AssessorForm::check);
    connect(m_passed, &QComboBox::currentIndexChanged, this, &AssessorForm::check);
    connect(m_by, &QComboBox::currentIndexChanged, this, &AssessorForm::check);
    connect(m_save, &QPushButton::clicked, this, [this] { Q_EMIT saveWanted(typed()); });
    connect(m_sign, &QPushButton::clicked, this,
            [this] { Q_EMIT signOffWanted(typed(), m_by->currentData().toLongLong()); });
}

void AssessorForm::show(const Result& result, const std::vector<Person>& assessors) {
    m_filling = true;
    m_kept = result.entry;
    m_open = result.cannotAssess.isEmpty() && !result.signedAt;
    m_comment->setPlainText(result.entry.comment);
    m_overrule->setChecked(result.entry.overrule);
    const Score automatic = result.automatic.value_or(Score{});
    m_score->setValue(result.entry.overrule ? result.entry.score : automatic.points);
    m_passed->setCurrentIndex((result.entry.overrule ? result.entry.passed : automatic.passed) ? 0 : 1);
    m_reason->setPlainText(result.entry.reason);
    fillAssessors(assessors);
    for (QPlainTextEdit* edit : {m_comment, m_reason}) edit->setReadOnly(!m_open);
    m_overrule->setEnabled(m_open);
    m_score->setEnabled(m_open);
    m_passed->setEnabled(m_open);
    m_signing->setVisible(m_open);
    m_save->setVisible(m_open);
    m_sign->setVisible(m_open);
    if (result.signedAt) {
        m_state->setText(tr("Signed off by %1 on %2. It can no longer be changed.")
                             .arg(result.signedBy, dateTime(*result.signedAt)));
    } else if (!result.cannotAssess.isEmpty()) {
        m_state->setText(result.cannotAssess);
    } else {
        m_state->setText(tr("The score is advice; the assessment is yours. Not signed off yet."));
    }
    m_trouble->say({});
    m_filling = false;
    check();
}

bool AssessorForm::changed() const { return m_open && !(typed() == m_kept); }

void AssessorForm::say(const QString& trouble) { m_trouble->say(trouble); }

Entry AssessorForm::typed() const {
    Entry e;
    e.comment = m_comment->toPlainText().trimmed();
    e.overrule = m_overrule->isChecked();
    if (!e.overrule) return e;
    e.score = m_score->value();
    e.passed = m_passed->currentData().toBool();
    e.reason = m_reason->toPlainText().trimmed();
    return e;
}

void AssessorForm::fillAssessors(const std::vector<Person>& assessors) {
    const QVariant before = m_by->currentData();
    m_by->clear();
    for (const Person& p : assessors)
        m_by->addItem(p.rank.isEmpty() ? p.name : tr("%1, %2").arg(p.name, p.rank), qlonglong(p.id));
    m_by->setCurrentIndex(before.isValid() ? m_by->findData(before) : -1);
    m_byNote->say(assessors.empty() && m_open
                      ? tr("no trainer is on the roster: add one there under People, role Trainer")
                      : QString());
}

void AssessorForm::check() {
    if (m_filling) return;
    const Entry e = typed();
    m_overruling->setVisible(e.overrule);
    const bool reasonMissing = e.overrule && e.reason.isEmpty();
    m_commentNote->say(lengthFault(e.comment, kLongestComment));
    m_reasonNote->say(reasonMissing ? tr("the reason is empty, expected why the result is overruled")
                                    : lengthFault(e.reason, kLongestReason));
    const bool sound = m_open && m_commentNote->ok() && m_reasonNote->ok();
    m_save->setEnabled(sound && !(e == m_kept));
    m_sign->setEnabled(sound && m_by->currentIndex() >= 0);
}

}  // namespace sagara::ui::roster
