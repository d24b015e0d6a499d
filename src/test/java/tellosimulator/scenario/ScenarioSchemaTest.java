package tellosimulator.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.networknt.schema.Error;
import com.networknt.schema.InputFormat;
import com.networknt.schema.Schema;
import com.networknt.schema.SchemaRegistry;
import com.networknt.schema.SpecificationVersion;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeSet;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Checks that the JSON schema for editors and the program agree. */
class ScenarioSchemaTest {

  private static final Path FILE = Path.of("docs/scenario.schema.json");
  private static final Path PAGE = Path.of("docs/scenarios.md");
  private static final Pattern EXAMPLE =
      Pattern.compile("^```yaml\n(.*?)^```", Pattern.MULTILINE | Pattern.DOTALL);

  private static final Schema SCHEMA =
      SchemaRegistry.withDefaultDialect(SpecificationVersion.DRAFT_2020_12)
          .getSchema(text(FILE), InputFormat.JSON);

  @TempDir private Path folder;

  private static List<String> names() {
    return Gallery.NAMES;
  }

  private static List<String> examples() {
    return EXAMPLE.matcher(text(PAGE)).results().map(match -> match.group(1)).toList();
  }

  /** Run with {@code -DwriteSchema=true} to rewrite the file. */
  @Test
  void theFileIsWhatTheCodecsSay() throws IOException {
    String said =
        new ObjectMapper()
                .writerWithDefaultPrettyPrinter()
                .writeValueAsString(ScenarioCodec.CODEC.jsonSchema())
                .replace("\r", "")
            + "\n";
    if (Boolean.getBoolean("writeSchema")) {
      Files.writeString(FILE, said);
    }
    assertThat(text(FILE))
        .as("%s; to write it anew: mvn test -Dtest=ScenarioSchemaTest -DwriteSchema=true", FILE)
        .isEqualTo(said);
  }

  @ParameterizedTest
  @MethodSource("names")
  void theScenariosOfTheProgramAreValid(String name) throws IOException {
    try (InputStream input = Gallery.class.getResourceAsStream(name + ".yaml")) {
      assertThat(errors(new String(input.readAllBytes(), StandardCharsets.UTF_8))).isEmpty();
    }
  }

  @ParameterizedTest
  @MethodSource("examples")
  void theExamplesOfThePageAreValidAndCanBeRead(String example) throws Exception {
    assertThat(errors(example)).isEmpty();
    assertThat(read(example)).isNotNull();
  }

  @Test
  void thePageHasAnExampleOfEveryKey() throws IOException {
    Set<String> keys = new TreeSet<>();
    for (JsonNode properties : new ObjectMapper().readTree(text(FILE)).findValues("properties")) {
      properties.fieldNames().forEachRemaining(key -> keys.add(key + ":"));
    }
    assertThat(keys).hasSizeGreaterThan(60);
    assertThat(String.join("", examples())).contains(keys);
  }

  @Test
  void whatTheProgramWritesIsValid() throws IOException {
    SplittableRandom random = new SplittableRandom(5);
    for (int i = 0; i < 50; i++) {
      Path file = folder.resolve("written.yaml");
      ScenarioFile.write(new RandomScenario(random).next(), file);
      assertThat(errors(text(file))).as("%s", text(file)).isEmpty();
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "room: {width: abc}",
        "room: {width: 50}",
        "room: {width: \"500\"}",
        "room: {length: 500}",
        "rom: {}",
        "name: 5",
        "name: {}",
        "name: {english: a}",
        "name: {en: 5}",
        "name: [a]",
        "difficulty: 6",
        "walls: papered",
        "grid: 5",
        "posters: [{wall: front, height: 100, width: 30}]",
        "obstacles: [{}]",
        "obstacles: [{box: {at: [0, 0], size: [1, 1]}}]",
        "obstacles: [{box: {at: [99, 0], size: [1, 1, 1]}, wall: {}}]",
        "obstacles: [{box: {at: [99, 0], size: [1, 1, 1], colour: rainbow}}]",
        "obstacles: [{cylinder: {at: [99, 0], radius: 5}}]",
        "obstacles: [{gate: {at: [99, 0], shape: ring, centre: 100}}]",
        "obstacles: [{gate: {at: [99, 0], shape: ring, centre: 90, diameter: 80, width: 5}}]",
        "obstacles: [{gate: {at: [99, 0], shape: frame, centre: 90, width: 80}}]",
        "pads: [{id: 9, at: [0, 0]}]",
        "pads: [{id: 1}]",
        "pads: [{id: 1, wall: left, height: 100, at: [0, 0]}]",
        "pads: [{id: 1, at: [0, 0], rotation: 5}]",
        "drones: [{}]",
        "drones: [{start: [0, 0], battery: 101}]",
        "drones: [{start: [0, 0], address: here}]",
        "drones: [{start: [0, 0], command-port: 0}]",
        "wind: {speed: -1}",
        "link: good",
        "faults: loss",
        "faults: [lost]",
        "faults: [{}]",
        "faults: [{fault: lost}]",
        "faults: [{fault: loss, share: lots}]",
        "faults: [{fault: loss, direction: up}]",
        "faults: [{fault: loss, drone: 0}]",
        "faults: [{fault: loss, at: 1, after: up}]",
        "faults: [{fault: loss, nth: 2}]",
        "crash-speed: -1",
        "crash-speed: soft",
        "time-factor: fast",
        "seed: 1.5",
        "goals: [{hover: {at: [0, 0, 30]}}]",
        "goals: [{pass: {}}]",
        "goals: [{land-on: {pad: 0}}]",
        "in-order: 1",
        "touch: never",
        "time-limit: 0"
      })
  void whatTheProgramRefusesTheSchemaRefusesToo(String text) {
    assertThat(errors(text)).isNotEmpty();
    assertThat(catchThrowableOfType(ScenarioException.class, () -> read(text))).isNotNull();
  }

  private static List<Error> errors(String yaml) {
    return SCHEMA.validate(yaml, InputFormat.YAML);
  }

  private Scenario read(String yaml) throws IOException, ScenarioException {
    Files.writeString(folder.resolve("face.png"), "");
    return ScenarioFile.read(Files.writeString(folder.resolve("example.yaml"), yaml));
  }

  private static String text(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
