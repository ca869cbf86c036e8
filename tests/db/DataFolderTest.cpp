#include "db/DataFolder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "Support.h"

namespace sagara::db {
namespace {

using namespace test;
namespace fs = std::filesystem;

/// Sets one variable, or removes it, until the end of the scope.
class Environment final {
public:
    Environment(const char* name, const std::optional<fs::path>& value) : m_name(name) {
        if (const char* old = std::getenv(name)) m_old = old;
        set(value);
    }
    ~Environment() { set(m_old); }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

private:
    void set(const std::optional<fs::path>& value) const {
        if (value) {
            ::setenv(m_name, value->c_str(), 1);
        } else {
            ::unsetenv(m_name);
        }
    }
    const char* m_name;
    std::optional<fs::path> m_old;
};

TEST(DataFolder, GivenFolderIsMadeWithItsRecordings) {
    const TemporaryFolder folder;
    const auto data = DataFolder::open(folder / "a/b");
    ASSERT_TRUE(data) << data.error();
    EXPECT_EQ(data->root(), folder / "a/b");
    EXPECT_EQ(data->database(), folder / "a/b/sagara.db");
    EXPECT_TRUE(fs::is_directory(folder / "a/b/recordings"));
    EXPECT_FALSE(fs::exists(data->database()));
    EXPECT_TRUE(DataFolder::open(folder / "a/b/")) << "a second time, with a slash";
}

TEST(DataFolder, WithoutOneXdgDataHomeCounts) {
    const TemporaryFolder folder;
    const Environment data("XDG_DATA_HOME", folder / "data"), home("HOME", folder / "home");
    EXPECT_EQ(DataFolder::open({}).value().root(), folder / "data/sagara");
}

TEST(DataFolder, WithoutXdgDataHomeItIsBelowHome) {
    const TemporaryFolder folder;
    const Environment home("HOME", folder.path());
    for (const std::optional<fs::path>& xdg :
         {std::optional<fs::path>(), std::optional<fs::path>("relative/ignored")}) {
        const Environment data("XDG_DATA_HOME", xdg);
        EXPECT_EQ(DataFolder::open({}).value().root(), folder / ".local/share/sagara");
    }
}

TEST(DataFolder, WithoutHomeTheMessageSaysSo) {
    const Environment data("XDG_DATA_HOME", {}), home("HOME", {});
    EXPECT_EQ(DataFolder::open({}).error(),
              "there is no data folder: neither XDG_DATA_HOME nor HOME is set; name one with --data");
}

TEST(DataFolder, EmptyNameIsRefused) {
    EXPECT_EQ(DataFolder::open(fs::path()).error(),
              "the name of the data folder is empty, expected a folder");
}

TEST(DataFolder, FileInItsPlaceIsNamed) {
    const TemporaryFolder folder;
    writeBytes(folder / "file", "I am a file");
    const std::string name = (folder / "file").string();
    EXPECT_EQ(DataFolder::open(folder / "file").error(),
              name + " is a file, expected a folder for Sagara's data");
    EXPECT_EQ(DataFolder::open(folder / "file/below").error(),
              name + "/below cannot be made: Not a directory");
    EXPECT_EQ(readBytes(folder / "file"), "I am a file");
}

TEST(DataFolder, FileInPlaceOfRecordingsIsNamed) {
    const TemporaryFolder folder;
    writeBytes(folder / "recordings", "");
    EXPECT_EQ(DataFolder::open(folder.path()).error(),
              (folder / "recordings").string() + " is a file, expected a folder for Sagara's data");
}

TEST(DataFolder, ReadOnlyFolderIsNamed) {
    const TemporaryFolder folder;
    fs::permissions(folder.path(), fs::perms(0555));
    const auto open = [&folder](const fs::path& wanted) {
        const auto data = DataFolder::open(wanted);
        throw DbError(DbError::Kind::Other, data ? "opened" : data.error());
    };
    const std::string other = kindPrefix(DbError::Kind::Other);
    EXPECT_EQ(errorAsOrdinaryUser([&] { open(folder.path()); }),
              other + folder.path().string() +
                  " may not be written, expected a folder where this user may make files");
    EXPECT_EQ(errorAsOrdinaryUser([&] { open(folder / "new"); }),
              other + (folder / "new").string() + " cannot be made: Permission denied");
}

TEST(DataFolder, FilesInsideAreNamedRelativeAndOthersWhole) {
    const TemporaryFolder folder;
    const DataFolder data = DataFolder::open(folder / "data").value();
    EXPECT_EQ(data.nameOf(data.recordings() / "a.sagarec"), "recordings/a.sagarec");
    EXPECT_EQ(data.nameOf(folder / "data/recordings/../recordings/a.sagarec"), "recordings/a.sagarec");
    EXPECT_EQ(data.nameOf(folder / "elsewhere.sagarec"), (folder / "elsewhere.sagarec").string());
    EXPECT_EQ(data.nameOf(folder / "data..but/not"), (folder / "data..but/not").string());
    for (const fs::path& file : {data.recordings() / "a.sagarec", folder / "elsewhere.sagarec"}) {
        EXPECT_EQ(data.pathOf(data.nameOf(file)), file);
    }
}

TEST(DataFolder, LinksToTheFolderAreTheFolder) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "real");
    fs::create_directory_symlink(folder / "real", folder / "link");
    const DataFolder data = DataFolder::open(folder / "link").value();
    EXPECT_EQ(data.root(), folder / "real");
    EXPECT_EQ(data.nameOf(folder / "link/recordings/a"), "recordings/a");
}

}  // namespace
}  // namespace sagara::db
