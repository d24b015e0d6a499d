package tellosimulator.grade;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.tuple;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.scenario.Assignment;
import tellosimulator.scenario.Assignment.Limits;
import tellosimulator.scenario.Assignment.Scale;
import tellosimulator.scenario.Assignment.Setup;
import tellosimulator.scenario.Assignment.Take;
import tellosimulator.words.Phrase;

/** Collects hand-ins from folders, files and archives. */
class HandInsTest {

  private static final Limits SMALL = new Limits(10, 10, 1000, 100, 10, 1);

  private static final Assignment ASSIGNMENT =
      new Assignment(
          "S",
          List.of(),
          1,
          Take.BEST,
          List.of("fly.py", "*.java"),
          Optional.empty(),
          Optional.empty(),
          Setup.DEFAULT,
          SMALL,
          Scale.DEFAULT);

  private static final String DAMAGED =
      "The zip is damaged or encrypted, or its names are not in UTF-8.";

  @TempDir private Path folder;

  private Path from;

  @BeforeEach
  void makeFolder() throws IOException {
    from = Files.createDirectories(folder.resolve("from"));
  }

  private void file(String name) throws IOException {
    Path file = from.resolve(name);
    Files.createDirectories(file.getParent());
    Files.writeString(file, name);
  }

  private List<HandIn> collected(Path path, Roster.Student... roster) throws IOException {
    Path into = Files.createTempDirectory(folder, "into");
    return new HandIns(ASSIGNMENT, into).collect(path, List.of(roster));
  }

  private Path zip(String... names) throws IOException {
    Path zip = folder.resolve("class.zip");
    try (OutputStream file = Files.newOutputStream(zip);
        ZipOutputStream out = new ZipOutputStream(file)) {
      for (String name : names) {
        out.putNextEntry(new ZipEntry(name));
        out.write(name.contains("huge") ? new byte[2 << 20] : new byte[] {'#'});
      }
    }
    return zip;
  }

  @Test
  void eachFolderAndEachProgramIsAHandIn() throws IOException {
    file("Ann/fly.py");
    file("Ann/fly.pyc");
    file("Bob/src/Fly.java");
    file("Eve/drone_final.py");
    file("carl.py");
    file("README.md");
    file(".git/fly.py");

    assertThat(collected(from))
        .extracting(HandIn::name, HandIn::file)
        .containsExactly(
            tuple("Ann", "fly.py"),
            tuple("Bob", "src/Fly.java"),
            tuple("Eve", ""),
            tuple("carl", "carl.py"));
  }

  @Test
  void aZipFromMoodleHasNamesAndNumbers() throws IOException {
    Path zip =
        zip(
            "Ann O'Neil_123_assignsubmission_file_/fly.py",
            "Bob_124_assignsubmission_file_/src/Fly.java",
            "Bob_124_assignsubmission_onlinetext_/onlinetext.html");

    List<HandIn> handIns = collected(zip, new Roster.Student("Ann O'Neil", "4711", "B"));

    assertThat(handIns).extracting(HandIn::name).containsExactly("Ann O'Neil", "Bob");
    assertThat(handIns).extracting(HandIn::id).containsExactly("4711", "124");
    assertThat(handIns).extracting(HandIn::group).containsExactly("B", "");
    assertThat(handIns).extracting(HandIn::file).containsExactly("fly.py", "src/Fly.java");
    assertThat(handIns).extracting(HandIn::folder).containsExactly("Ann-O-Neil", "Bob");
  }

  @Test
  void aZipWithinAHandInIsUnpacked() throws IOException {
    Files.createDirectories(from.resolve("Ann"));
    Files.move(zip("drone/fly.py"), from.resolve("Ann/work.zip"));

    assertThat(collected(from)).extracting(HandIn::file).containsExactly("drone/fly.py");
  }

  @Test
  void whatLeadsOutOfItsFolderIsRefusedForThatHandInOnly() throws IOException {
    Path zip = zip("Ann/fly.py", "Bob/../../evil.py", "Bob/fly.py", "Eve/huge", "Eve/fly.py");

    List<HandIn> handIns = collected(zip);

    assertThat(handIns)
        .extracting(handIn -> handIn.problem().map(Phrase::english).orElse("none"))
        .containsExactly(
            "none",
            "The zip has a file that would be written outside of its folder.",
            "It is larger than 1 MB or 10000 files.");
    assertThat(handIns).extracting(HandIn::file).containsExactly("fly.py", "", "");
    assertThat(folder.resolve("evil.py")).doesNotExist();
  }

  @Test
  void linksOutOfAHandInAreRefused() throws IOException {
    file("Ann/fly.py");
    file("Bob/fly.py");
    Files.createSymbolicLink(from.resolve("Ann/bob.py"), from.resolve("Bob/fly.py"));
    Files.createSymbolicLink(from.resolve("Bob/again.py"), from.resolve("Bob/fly.py"));

    List<HandIn> handIns = collected(from);

    assertThat(handIns.get(0).problem().map(Phrase::english))
        .contains("The link or device \"bob.py\" leads out of the hand-in.");
    assertThat(handIns.get(1).problem()).isEmpty();
  }

  @Test
  void whoHandedInNothingHasARow() throws IOException {
    file("Ann/fly.py");
    Path roster = folder.resolve("roster.csv");
    Files.writeString(roster, "\uFEFFname;id;group\r\n\"Ann\";1;A\r\nBob;2\r\n");

    List<HandIn> handIns = collected(from, Roster.read(roster).toArray(Roster.Student[]::new));

    assertThat(handIns).extracting(HandIn::name).containsExactly("Ann", "Bob");
    assertThat(handIns).extracting(HandIn::id).containsExactly("1", "2");
    assertThat(handIns.get(1).problem().map(Phrase::english)).contains("Nothing was handed in.");
    assertThat(handIns).extracting(HandIn::obstacle).last().isEqualTo("nothing handed in");
  }

  @Test
  void theRosterIsATableAsSpreadsheetsWriteIt() throws IOException {
    Path roster = folder.resolve("roster.csv");
    Files.writeString(
        roster,
        "name,id,group\n\"Doe, Jane\",1,\"A; B\"\n \"the \"\"Rock\"\"\",2\nBob \"B\" S,3,\"\"\n");

    assertThat(Roster.read(roster))
        .containsExactly(
            new Roster.Student("Doe, Jane", "1", "A; B"),
            new Roster.Student("the \"Rock\"", "2", ""),
            new Roster.Student("Bob \"B\" S", "3", ""));
  }

  @Test
  void theHeadingOfARosterGivesTheOrderAndUnknownColumnsAreRefused() throws IOException {
    Path roster = folder.resolve("roster.csv");
    Files.writeString(roster, "Group,Name\nA,Ann\n");
    assertThat(Roster.read(roster)).containsExactly(new Roster.Student("Ann", "", "A"));

    Files.writeString(roster, "name,mail\nAnn,x\n");
    assertThatThrownBy(() -> Roster.read(roster))
        .hasMessage(roster + " has the column \"mail\": expected name, id and group");
  }

  @Test
  void whatIsNotThereIsSaid() {
    Path nowhere = folder.resolve("nowhere");

    assertThatThrownBy(() -> collected(nowhere))
        .hasMessageStartingWith(nowhere + " does not exist: expected a folder");
  }

  @Test
  void twoStudentsOfOneNameHaveARowEach() throws IOException {
    file("Bob_17_assignsubmission_file_/fly.py");
    file("Bob_18_assignsubmission_file_/fly.py");
    file("Eve/fly.py");

    List<HandIn> handIns =
        collected(
            from,
            new Roster.Student("Bob", "1", "A"),
            new Roster.Student("Bob", "2", "B"),
            new Roster.Student("Bob", "3", "C"),
            new Roster.Student("Eve", "4", "A"));

    assertThat(handIns)
        .extracting(HandIn::folder, HandIn::id, HandIn::file)
        .containsExactly(
            tuple("Bob", "1", "fly.py"),
            tuple("Bob-2", "2", "fly.py"),
            tuple("Bob-3", "3", ""),
            tuple("Eve", "4", "fly.py"));
  }

  @Test
  void aZipThatIsCutOffIsThatHandInsProblemOnly() throws IOException {
    file("Ann/fly.py");
    byte[] whole = Files.readAllBytes(zip("fly.py", "more.py"));
    Files.createDirectories(from.resolve("Bob"));
    Files.write(from.resolve("Bob/work.zip"), Arrays.copyOf(whole, whole.length / 2));
    whole[6] |= 1; // the flag of an encrypted file, in its header and in the directory
    int directory = new String(whole, StandardCharsets.ISO_8859_1).indexOf("PK\u0001\u0002");
    whole[directory + 8] |= 1;
    Files.createDirectories(from.resolve("Eve"));
    Files.write(from.resolve("Eve/work.zip"), whole);

    List<HandIn> handIns = collected(from);

    assertThat(handIns)
        .extracting(handIn -> handIn.problem().map(Phrase::english).orElse("none"))
        .containsExactly("none", DAMAGED, DAMAGED);
    assertThat(handIns.get(1).obstacle()).isEqualTo("not accepted");
    assertThat(handIns).extracting(HandIn::file).containsExactly("fly.py", "", "");
  }

  @Test
  void aDamagedZipOfTheClassIsNotGradedInPart() throws IOException {
    Path zip = zip("Ann/fly.py", "Bob/fly.py", "Eve/fly.py");
    byte[] whole = Files.readAllBytes(zip);
    Files.write(zip, Arrays.copyOf(whole, whole.length * 2 / 3));

    assertThatThrownBy(() -> collected(zip))
        .isInstanceOf(IOException.class)
        .hasMessageStartingWith(zip + " is no zip, or it is damaged");
  }

  @Test
  void namesThatCannotBeAreThatHandInsProblemOnly() throws IOException {
    Path zip =
        zip(
            "Ann",
            "Ann/fly.py",
            "Bob/" + "x".repeat(300),
            "C".repeat(300) + "/fly.py",
            "Eve/fly.py");

    List<HandIn> handIns = collected(zip);

    String impossible = "The zip has a file whose name is not possible here.";
    assertThat(handIns)
        .extracting(HandIn::folder, handIn -> handIn.problem().map(Phrase::english).orElse("none"))
        .containsExactly(
            tuple("Ann", impossible),
            tuple("Bob", impossible),
            tuple("C".repeat(60), impossible),
            tuple("Eve", "none"));
  }
}
