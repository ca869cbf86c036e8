#include "ui/editor/ScenarioDraft.h"

#include <QUndoCommand>
#include <utility>

namespace sagara::ui::editor {

constexpr int kMostSteps = 200;

class ScenarioDraft::Change final : public QUndoCommand {
public:
    Change(ScenarioDraft& draft, const QString& what, QString going, std::shared_ptr<const Json> after)
        : QUndoCommand(what),
          m_draft(draft),
          m_going(std::move(going)),
          m_before(draft.m_document),
          m_after(std::move(after)) {}

    void undo() override { m_draft.show(m_before); }
    void redo() override { m_draft.show(m_after); }
    int id() const override { return m_going.isEmpty() ? -1 : 1; }
    bool mergeWith(const QUndoCommand* other) override {
        const auto* next = static_cast<const Change*>(other);
        if (next->m_going != m_going) return false;
        m_after = next->m_after;
        return true;
    }

private:
    ScenarioDraft& m_draft;
    QString m_going;
    std::shared_ptr<const Json> m_before;
    std::shared_ptr<const Json> m_after;
};

ScenarioDraft::ScenarioDraft(QObject* parent)
    : QObject(parent), m_document(std::make_shared<const Json>(Json::object())) {
    m_history.setUndoLimit(kMostSteps);
    connect(&m_history, &QUndoStack::cleanChanged, this, [this] { Q_EMIT savedChanged(isSaved()); });
}

void ScenarioDraft::reset(Json document, bool saved) {
    m_document = std::make_shared<const Json>(std::move(document));
    m_stored = saved;
    m_history.clear();
    Q_EMIT changed();
    Q_EMIT savedChanged(isSaved());
}

void ScenarioDraft::markSaved() {
    m_stored = true;
    m_history.setClean();
    endGoing();
    Q_EMIT savedChanged(true);
}

void ScenarioDraft::edit(const QString& what, const std::function<void(Json&)>& work, const QString& going) {
    auto after = std::make_shared<Json>(*m_document);
    work(*after);
    if (*after == *m_document) return;
    const QString key = going.isEmpty() ? QString() : going + QString::number(m_going);
    m_history.push(new Change(*this, what, key, std::move(after)));
}

void ScenarioDraft::set(const std::string& path, Json value, const QString& what, const QString& going) {
    edit(what, [&](Json& document) { put(document, path, std::move(value)); }, going);
}

void ScenarioDraft::show(std::shared_ptr<const Json> document) {
    m_document = std::move(document);
    Q_EMIT changed();
}

}  // namespace sagara::ui::editor
