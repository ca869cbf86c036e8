#include "db/ClassRepository.h"

#include <gtest/gtest.h>

#include "Support.h"

namespace sagara::db {
namespace {

using namespace test;

class Classes : public ::testing::Test {
protected:
    ClassId added(const char* name) { return *m_classes.add(name, kMorning); }
    PersonId person(const char* name, std::optional<ClassId> schoolClass) {
        NewPerson p;
        p.name = name;
        p.schoolClass = schoolClass;
        return *m_people.add(p, kMorning);
    }
    TemporaryFolder m_folder;
    Database m_db{m_folder / "sagara.db"};
    ClassRepository m_classes{m_db};
    PersonRepository m_people{m_db};
};

TEST_F(Classes, AreListedByNameWithoutTheRetired) {
    const ClassId b = added("Watch B");
    added("  Watch A ");
    m_classes.retire(added("Old"));
    const auto list = m_classes.inUse();
    ASSERT_EQ(list.size(), 2u);
    EXPECT_EQ(list[0].name, "Watch A");
    EXPECT_EQ(list[1].id, b);
    EXPECT_FALSE(m_classes.findByName("Old"));
    EXPECT_TRUE(m_classes.add("Old", kNoon));
}

TEST_F(Classes, UnusableNamesAreRefused) {
    const ClassId a = added("Watch A");
    EXPECT_EQ(m_classes.add("Watch A", kNoon).error(), ClassError::NameTaken);
    EXPECT_EQ(m_classes.add(" ", kNoon).error(), ClassError::NameEmpty);
    EXPECT_EQ(m_classes.add(std::string(81, 'x'), kNoon).error(), ClassError::NameTooLong);
    EXPECT_EQ(m_classes.add("a\nb", kNoon).error(), ClassError::NameUnreadable);
    EXPECT_EQ(m_classes.rename(added("Watch B"), "Watch A").error(), ClassError::NameTaken);
    EXPECT_TRUE(m_classes.rename(a, "Watch 1"));
    EXPECT_EQ(m_classes.find(a)->name, "Watch 1");
}

TEST_F(Classes, PeopleAreMovedBetweenThem) {
    const ClassId a = added("A"), b = added("B");
    const PersonId silva = person("Silva", a), dias = person("Dias", a);
    person("Perera", std::nullopt);
    EXPECT_EQ(m_people.of(a).size(), 2u);
    m_people.move(silva, b);
    EXPECT_EQ(m_people.of(a).front().id, dias);
    m_people.move(silva, std::nullopt);
    EXPECT_TRUE(m_people.of(b).empty());
}

TEST_F(Classes, ClassThatIsNotThereIsRefused) {
    NewPerson p;
    p.name = "Silva";
    p.schoolClass = ClassId{99};
    EXPECT_THROW((void)m_people.add(p, kMorning), DbError);
}

}  // namespace
}  // namespace sagara::db
