#pragma once

#include <QFutureWatcher>
#include <QObject>
#include <QTimer>

#include "core/exercise/World.h"
#include "ui/editor/EditorContext.h"

namespace sagara::ui::editor {

using Problems = std::vector<core::config::Problem>;

/// The exercise of a draft, or what is wrong with it. Faults of other documents (a vessel's) have no path in
/// this one. Takes a few tenths of a second.
core::Result<std::shared_ptr<const core::World>, Problems> worldOf(const std::string& text,
                                                                   const core::DocumentSource& documents,
                                                                   core::WorldUse use);

/// CONTROLLER: has the draft read by the loader in another thread, soon after it was changed.
class Validator final : public QObject {
    Q_OBJECT
public:
    explicit Validator(EditorContext& context, QObject* parent = nullptr);

    const Problems& problems() const { return m_problems; }
    /// Whether the problems are those of the draft as it is.
    bool upToDate() const { return m_checked == m_context.draft().shared(); }

Q_SIGNALS:
    void checked();

private:
    void check();

    EditorContext& m_context;
    QTimer m_soon;
    QFutureWatcher<Problems> m_worker;
    std::shared_ptr<const Json> m_checking;
    std::shared_ptr<const Json> m_checked;
    Problems m_problems;
};

}  // namespace sagara::ui::editor
