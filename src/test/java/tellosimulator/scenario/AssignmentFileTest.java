package tellosimulator.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.networknt.schema.InputFormat;
import com.networknt.schema.Schema;
import com.networknt.schema.SchemaRegistry;
import com.networknt.schema.SpecificationVersion;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.fault.LinkPreset;
import tellosimulator.profile.Behavior;
import tellosimulator.scenario.Assignment.AssignedCourse;
import tellosimulator.scenario.Assignment.Limits;
import tellosimulator.scenario.Assignment.Pace;
import tellosimulator.scenario.Assignment.Scale;
import tellosimulator.scenario.Assignment.Setup;
import tellosimulator.scenario.Assignment.Take;

/** Reads assignments. */
class AssignmentFileTest {

  private static final Path SCHEMA = Path.of("docs/assignment.schema.json");

  private static final String WHOLE =
      """
      name: Slalom
      courses: [slalom, {scenario: own.yaml, seeds: [1, 2, 3]}]
      attempts: 2
      take: mean
      entry: "*.py"
      command: python3 -u {file}
      build: make all
      options: {behaviour: measured, profile: tt, link: lab, faults: [loss state 20%], time-factor: real}
      limits: {wall: 60, time: 2min, output: 5000, memory: 512, processes: 8, disk: 50}
      scale: {kind: range, from: 4.0, to: 6.0, passed-from: 60}
      """;

  @TempDir private Path folder;

  private Path file(String text) throws IOException {
    Files.writeString(folder.resolve("own.yaml"), "goals:\n  - land: {at: [0, 0], radius: 30}\n");
    return Files.writeString(folder.resolve("assignment.yaml"), text);
  }

  @Test
  void everyKeyIsRead() throws Exception {
    Assignment read = AssignmentFile.read(file(WHOLE));

    assertThat(read.courses())
        .containsExactly(
            new AssignedCourse("slalom", List.of()),
            new AssignedCourse(folder.resolve("own.yaml").toString(), List.of(1L, 2L, 3L)));
    assertThat(read.attempts()).isEqualTo(2);
    assertThat(read.take()).isEqualTo(Take.MEAN);
    assertThat(read.entry()).containsExactly("*.py");
    assertThat(read.command()).contains("python3 -u {file}");
    assertThat(read.build()).contains("make all");
    assertThat(read.setup().behavior()).contains(Behavior.MEASURED);
    assertThat(read.setup().link()).contains(LinkPreset.LAB);
    assertThat(read.setup().faults()).hasSize(1);
    assertThat(read.setup().pace()).isEqualTo(Pace.REAL);
    assertThat(read.limits()).isEqualTo(new Limits(60, 120, 5000, 512, 8, 50));
    assertThat(read.scale()).isEqualTo(new Scale(true, 4, 6, 60));
  }

  @Test
  void nameAndCoursesAreEnough() throws Exception {
    Assignment read = AssignmentFile.read(file("name: A\ncourses: [slalom]\n"));

    assertThat(read.attempts()).isEqualTo(1);
    assertThat(read.take()).isEqualTo(Take.BEST);
    assertThat(read.setup()).isEqualTo(Setup.DEFAULT);
    assertThat(read.limits()).isEqualTo(Limits.DEFAULT);
    assertThat(read.scale()).isEqualTo(Scale.DEFAULT);
  }

  @Test
  void allMistakesAreReportedAtOnceWithTheirPlaces() throws IOException {
    Path file =
        file(
            """
            name: A
            courses: [slalon, {scenario: slalom, seeds: [x]}]
            attempt: 2
            take: worst
            scale: {kind: range, from: 1}
            """);

    ScenarioException wrong =
        catchThrowableOfType(ScenarioException.class, () -> AssignmentFile.read(file));

    assertThat(wrong.diagnostics().stream().map(each -> each.toString().replace(file + ":", "")))
        .containsExactly(
            "2:11: there is neither a file nor a scenario \"slalon\"",
            "2:46: expected a whole number of at most 18 digits, found \"x\"",
            "3:1: an assignment has no key \"attempt\", did you mean attempts?",
            "4:7: expected one of best, last, mean, found \"worst\"",
            "5:8: a scale needs the key to");
  }

  @Test
  void whatContradictsItselfIsReported() throws IOException {
    Path file =
        file(
            """
            name: A
            courses:
              - slalom
              - slalom
              - {scenario: own.yaml, seeds: []}
            """);
    assertThat(said(file)).containsExactly("5:33: expected at least one seed, found none");
    file("name: A\ncourses: [slalom, slalom, {scenario: own.yaml, seeds: [1, 1]}]\n");
    assertThat(said(file)).containsExactly("2:55: a seed is there twice");
    file("name: A\ncourses: [slalom, slalom]\ncommand: python3 -u\n");
    assertThat(said(file))
        .containsExactly(
            "2:10: the course slalom is there twice: list its seeds in one place",
            "3:10: the command starts no file: write {file} where its name belongs");
    file("name: A\ncourses: [slalom]\nscale: {kind: range, from: 4, to: 4}\n");
    assertThat(said(file)).containsExactly("3:35: a scale needs two different grades");
    file("");
    assertThat(said(file)).containsExactly("1:1: the file is empty");
  }

  private static List<String> said(Path file) {
    return catchThrowableOfType(ScenarioException.class, () -> AssignmentFile.read(file))
        .diagnostics()
        .stream()
        .map(each -> each.toString().replace(file + ":", ""))
        .toList();
  }

  @Test
  void aPatternThatIsNoneIsReportedWithItsPlace() throws IOException {
    Path file = file("name: A\ncourses: [slalom]\nentry: [fly.py, \"[x.py\"]\n");

    assertThat(catchThrowableOfType(ScenarioException.class, () -> AssignmentFile.read(file)))
        .hasMessage(
            file
                + ":3:17: expected the name of a file, or a pattern such as \"*.py\","
                + " found \"[x.py\"");
  }

  @Test
  void flightsWithoutEndAreRefused() throws IOException {
    Path file = file("name: A\ncourses: []\n");

    assertThat(catchThrowableOfType(ScenarioException.class, () -> AssignmentFile.read(file)))
        .hasMessage(file + ":2:10: an assignment needs at least one course");
  }

  @Test
  void nothingIsDrawnFromARange() throws IOException {
    Path file = file("name: A\ncourses: [slalom]\nlimits: {wall: 30..60}\n");

    assertThat(catchThrowableOfType(ScenarioException.class, () -> AssignmentFile.read(file)))
        .hasMessage(file + ":3:16: expected seconds from 1 to 36000, found \"30..60\"");
  }

  /** Run with {@code -DwriteSchema=true} to rewrite the file. */
  @Test
  void theSchemaIsWhatTheCodecSays() throws IOException {
    String said =
        new ObjectMapper()
                .writerWithDefaultPrettyPrinter()
                .writeValueAsString(AssignmentCodec.CODEC.jsonSchema())
                .replace("\r", "")
            + "\n";
    if (Boolean.getBoolean("writeSchema")) {
      Files.writeString(SCHEMA, said);
    }
    assertThat(Files.readString(SCHEMA))
        .as("%s; to write it again: mvn test -Dtest=AssignmentFileTest -DwriteSchema=true", SCHEMA)
        .isEqualTo(said);
    Schema schema =
        SchemaRegistry.withDefaultDialect(SpecificationVersion.DRAFT_2020_12)
            .getSchema(said, InputFormat.JSON);
    assertThat(schema.validate(WHOLE, InputFormat.YAML)).isEmpty();
    assertThat(schema.validate("name: A\n", InputFormat.YAML)).isNotEmpty();
  }
}
