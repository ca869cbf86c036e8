#include "db/PersonRepository.h"

#include <gtest/gtest.h>

#include "Support.h"

namespace sagara::db {
namespace {

using namespace test;

class People : public ::testing::Test {
protected:
    TemporaryFolder m_folder;
    Database m_db{m_folder / "sagara.db"};
    PersonRepository m_people{m_db};
};

TEST_F(People, AddedPersonIsFoundByNameAndById) {
    const auto id = m_people.add("Nimal Perera", Role::Trainee, kMorning);
    ASSERT_TRUE(id);
    const auto byName = m_people.findByName("Nimal Perera");
    ASSERT_TRUE(byName);
    EXPECT_EQ(byName->id, *id);
    EXPECT_EQ(byName->role, Role::Trainee);
    EXPECT_EQ(byName->created, kMorning);
    EXPECT_EQ(m_people.find(*id)->name, "Nimal Perera");
    EXPECT_FALSE(m_people.findByName("nimal perera"));
}

TEST_F(People, EveryRoleComesBack) {
    for (const Role role : {Role::Trainee, Role::Trainer, Role::Admin}) {
        const auto id = m_people.add(toText(role), role, kMorning);
        EXPECT_EQ(m_people.find(*id)->role, role);
        EXPECT_EQ(parseRole(toText(role)), role);
    }
    EXPECT_FALSE(parseRole("captain"));
}

TEST_F(People, NameIsTrimmedBeforeItIsComparedOrStored) {
    ASSERT_TRUE(m_people.add("  Silva \t", Role::Trainer, kMorning));
    EXPECT_EQ(m_people.findByName(" Silva")->name, "Silva");
    EXPECT_EQ(m_people.add("Silva\n", Role::Trainee, kMorning).error(), AddError::NameTaken);
}

struct NameRow {
    const char* title;
    std::string name;
    AddError expected;
};
class UnusableName : public People, public ::testing::WithParamInterface<NameRow> {};
TEST_P(UnusableName, IsRefusedAndNobodyIsAdded) {
    const auto id = m_people.add(GetParam().name, Role::Trainee, kMorning);
    ASSERT_FALSE(id);
    EXPECT_EQ(id.error(), GetParam().expected);
    EXPECT_FALSE(toText(id.error()).empty());
    EXPECT_TRUE(m_people.inUse().empty());
}
INSTANTIATE_TEST_SUITE_P(Names, UnusableName,
                         ::testing::Values(NameRow{"Empty", "", AddError::NameEmpty},
                                           NameRow{"Blank", " \t\n", AddError::NameEmpty},
                                           NameRow{"Long", std::string(81, 'x'), AddError::NameTooLong},
                                           NameRow{"LineBreak", "a\nb", AddError::NameUnreadable},
                                           NameRow{"Nul", std::string("a\0b", 3), AddError::NameUnreadable},
                                           NameRow{"NotUtf8", "\xff\xfe", AddError::NameUnreadable},
                                           NameRow{"CutUtf8", "caf\xc3", AddError::NameUnreadable}),
                         [](const auto& row) { return std::string(row.param.title); });

TEST_F(People, EightyCharactersOfAnyAlphabetAreAccepted) {
    std::string name;
    for (int i = 0; i < 80; ++i) name += i % 2 ? "ශ" : "🚢";
    ASSERT_TRUE(m_people.add(name, Role::Trainee, kMorning));
    EXPECT_TRUE(m_people.findByName(name));
    EXPECT_EQ(m_people.add(name + "x", Role::Trainee, kMorning).error(), AddError::NameTooLong);
}

TEST_F(People, NamesLikeSqlAreStoredVerbatim) {
    for (const char* name :
         {"Robert'); DROP TABLE person;--", "\" OR 1=1", "%1 ? :name", "' || (SELECT 1) || '"}) {
        ASSERT_TRUE(m_people.add(name, Role::Trainee, kMorning)) << name;
        EXPECT_EQ(m_people.findByName(name)->name, name);
    }
    EXPECT_EQ(m_people.inUse().size(), 4u);
    EXPECT_TRUE(m_db.integrity().empty());
}

TEST_F(People, RetiredIsHiddenAndFreesTheNameYetKeepsTheRow) {
    const PersonId old = *m_people.add("Fernando", Role::Admin, kMorning);
    m_people.retire(old);
    EXPECT_TRUE(m_people.inUse().empty());
    EXPECT_FALSE(m_people.findByName("Fernando"));
    EXPECT_TRUE(m_people.find(old)->retired);
    const auto successor = m_people.add("Fernando", Role::Trainee, kNoon);
    ASSERT_TRUE(successor);
    EXPECT_NE(*successor, old);
    m_people.retire(*successor);  // two retired people may share a name
    EXPECT_TRUE(m_people.inUse().empty());
}

TEST_F(People, EveryFieldComesBackAndMayBeChanged) {
    NewPerson person{"Silva", Role::Trainee, " NA-17 ", "Sub-Lieutenant", "silva@example.org", {}};
    const PersonId id = *m_people.add(person, kMorning);
    EXPECT_EQ(m_people.find(id)->number, "NA-17");
    EXPECT_EQ(m_people.find(id)->rank, "Sub-Lieutenant");
    EXPECT_EQ(m_people.find(id)->note, "silva@example.org");
    person.rank = "Lieutenant";
    person.role = Role::Trainer;
    ASSERT_TRUE(m_people.change(id, person));
    EXPECT_EQ(m_people.find(id)->rank, "Lieutenant");
    EXPECT_EQ(m_people.find(id)->role, Role::Trainer);
}

TEST_F(People, NamesAndNumbersAreOnePersonsOnly) {
    const PersonId silva = *m_people.add({"Silva", Role::Trainee, "17", "", "", {}}, kMorning);
    const PersonId dias = *m_people.add({"Dias", Role::Trainee, "", "", "", {}}, kMorning);
    ASSERT_TRUE(m_people.add({"Perera", Role::Trainee, "", "", "", {}}, kMorning));  // many have no number
    EXPECT_EQ(m_people.add({"Fernando", Role::Trainee, "17", "", "", {}}, kMorning).error(),
              AddError::NumberTaken);
    EXPECT_EQ(m_people.change(dias, {"Dias", Role::Trainee, "17", "", "", {}}).error(),
              AddError::NumberTaken);
    EXPECT_EQ(m_people.change(dias, {"Silva", Role::Trainee, "", "", "", {}}).error(), AddError::NameTaken);
    m_people.retire(silva);
    ASSERT_TRUE(m_people.change(dias, {"Dias", Role::Trainee, "17", "", "", {}}));
    EXPECT_EQ(m_people.restore(silva).error(), AddError::NumberTaken);
    EXPECT_EQ(m_people.all().size(), 3u);
}

TEST_F(People, FieldsThatCannotBeKeptAreRefused) {
    const auto error = [this](std::string number, std::string rank, std::string note) {
        return m_people.add({"Silva", Role::Trainee, number, rank, note, {}}, kMorning).error();
    };
    EXPECT_EQ(error(std::string(41, '1'), "", ""), AddError::NumberUnusable);
    EXPECT_EQ(error("", "a\nb", ""), AddError::RankUnusable);
    EXPECT_EQ(error("", "", std::string(401, 'x')), AddError::NoteUnusable);
    EXPECT_TRUE(m_people.inUse().empty());
}

TEST_F(People, ListIsByName) {
    for (const char* name : {"Silva", "Dias", "Perera"})
        ASSERT_TRUE(m_people.add(name, Role::Trainee, kMorning));
    std::string names;
    for (const PersonRecord& p : m_people.inUse()) names += p.name + " ";
    EXPECT_EQ(names, "Dias Perera Silva ");
}

}  // namespace
}  // namespace sagara::db
