#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/files/AssetSource.h"
#include "core/base/Utc.h"
#include "core/exercise/Documents.h"
#include "db/DataFolder.h"
#include "db/Database.h"

namespace sagara::run {

/// The installation as a program sees it: data folder, database and shipped documents. At its first start the
/// database takes in assets/; later it takes in what a newer Sagara ships, unless the user has a document of
/// that name of his own.
///
/// A database that cannot be used (locked, damaged, newer, read-only, full) does not stop a run: the
/// documents then come from assets/, `trouble` says what is the matter, and the run is filed later from its
/// recording.
class Store final : public core::DocumentSource {
public:
    /// The error is for the person who chose the folder.
    static core::Result<std::unique_ptr<Store>, std::string> open(
        const std::optional<std::filesystem::path>& dataFolder);

    /// Pictures come from assets/, where their model files are. Throws DbError, for one when the document is
    /// not the one that was stored.
    std::optional<std::string> find(core::DocumentKind kind, const std::string& id) const override;

    std::shared_ptr<core::SeaHulls> hulls() const override { return m_hulls; }

    const files::AssetSource& assets() const { return m_assets; }  ///< what is shipped
    const db::DataFolder& folder() const { return m_folder; }
    db::Database* database() const { return m_database.get(); }  ///< null when it cannot be used
    const std::string& trouble() const { return m_trouble; }

    /// What is wrong with a backup that somebody wants to restore; empty: it is a whole database of ours.
    /// Reads a copy beside the database, so that the backup stays as it is. From any thread.
    std::vector<std::string> checkBackup(const std::filesystem::path& backup) const;
    /// Puts a backup in place of the database and opens it; the database before is kept as `keptDatabase`.
    /// All or nothing. Only while nobody holds on to `database()`: not while a run is on.
    std::optional<std::string> restoreDatabase(const std::filesystem::path& backup);
    std::filesystem::path keptDatabase() const { return m_folder.root() / "sagara-before-restore.db"; }
    /// 3D models that people have attached to vessels.
    std::filesystem::path ownModels() const { return m_folder.root() / "models"; }

private:
    explicit Store(db::DataFolder folder);
    void openDatabase();
    void takeInAssets();

    db::DataFolder m_folder;
    std::shared_ptr<core::SeaHulls> m_hulls;  ///< with their cache: a worker may outlive the store
    files::AssetSource m_assets;
    std::unique_ptr<db::Database> m_database;
    std::string m_trouble;
};

/// The wall clock.
core::Utc now();

}  // namespace sagara::run
