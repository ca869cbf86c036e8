#pragma once

#include <QUndoStack>
#include <functional>
#include <memory>

#include "ui/editor/Json.h"

namespace sagara::ui::editor {

/// MODEL: the document as it is being written, with its history. Every state is kept whole and is immutable,
/// so that a worker thread can have it too.
class ScenarioDraft final : public QObject {
    Q_OBJECT
public:
    explicit ScenarioDraft(QObject* parent = nullptr);

    /// Opened or made anew: there is nothing to undo. `saved`: it is so in the database.
    void reset(Json document, bool saved);
    void markSaved();
    bool isSaved() const { return m_stored && m_history.isClean(); }

    const Json& document() const { return *m_document; }
    std::shared_ptr<const Json> shared() const { return m_document; }
    const Json* at(const std::string& path) const { return find(*m_document, path); }

    /// One step of the history. Steps in a row with the same `going` (a field typed in, a handle dragged) are
    /// one. A work that changes nothing is none.
    void edit(const QString& what, const std::function<void(Json&)>& work, const QString& going = {});
    void set(const std::string& path, Json value, const QString& what, const QString& going = {});
    /// The field is left, the handle let go: what comes next is a step of its own.
    void endGoing() { ++m_going; }

    QUndoStack& history() { return m_history; }

Q_SIGNALS:
    void changed();
    void savedChanged(bool saved);

private:
    class Change;
    void show(std::shared_ptr<const Json> document);

    std::shared_ptr<const Json> m_document;
    QUndoStack m_history;
    int m_going = 0;
    bool m_stored = false;
};

}  // namespace sagara::ui::editor
