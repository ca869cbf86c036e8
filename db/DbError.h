#pragma once

#include <stdexcept>
#include <string>

namespace sagara::db {

/// The machine failed us: disk, lock, rights, a file that is not what it should be. `what()` is for a person:
/// it names the file, what was found, what is accepted and what to do. Not for what people type (that is a
/// Result).
class DbError : public std::runtime_error {  // not final: std::throw_with_nested derives from it
public:
    enum class Kind {
        CannotOpen,  ///< folder or file missing, unreadable, or of the wrong sort
        Locked,      ///< another program held it for longer than the busy timeout
        ReadOnly,    ///< may be read, may not be written
        Full,        ///< no room on the disk
        Damaged,     ///< not a database, or a broken one
        Newer,       ///< written by a newer Sagara
        Foreign,     ///< a healthy database of another application
        Other
    };

    DbError(Kind kind, const std::string& message) : std::runtime_error(message), m_kind(kind) {}
    Kind kind() const { return m_kind; }

private:
    Kind m_kind;
};

}  // namespace sagara::db
