package tellosimulator.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import tellosimulator.goal.Challenge;
import tellosimulator.scenario.ScenarioCodec.ParsedScenario;
import tellosimulator.scenario.ScenarioDocument.Preserved;
import tellosimulator.sim.SimConfig;
import tellosimulator.world.Obstacle;

/**
 * Makes a thousand random edits of many texts. Each edit may change only the lines of its item, and
 * the text must contain the edited scenario.
 */
@Tag("slow")
class RandomEditsTest {

  private static final int EDITS = 1000;

  /** Number of edits of a text before the next one is used. */
  private static final int EDITS_OF_ONE = 20;

  private static final String BLOCKS =
      """
      # yaml-language-server: $schema=scenario.schema.json

      ---
      # comment at the top
      name: "Blocks"    # said twice

      room:             #in of the school
        depth: 6.0e2    #in x
        #in y
        width:   800
      time-limit: 60

      obstacles:        # from the left
      # a group of two

      - box:
          #in the teacher's
          name: desk
          at:
            - 100       #in x
            - -0050.50  #in y
          size: [60,
                 120,   #in wide
                 75]
          colour: brown
          # end of the desk
      -   wall:
            to: [200, 0]
            from: [0, 0.25]
            height: 100 # low
      # - box: {at: [0, 0], size: [1, 1, 1]}

      - gate: {name: 'first', shape: ring, at: [0, 150], diameter: 80, #in wide
          centre: 120}

      drones:
        -
          start: [-150, 0]
          battery: 50.0
        - colour: "#FF0000"
          start: [-150, 100]

      pads:
          - {id: 1, at: [0, -150]}  # here
          # and there
          - {id: 7, wall: left, height: 100}
      goals:
        - pass: {gate: first}       # through
        - land-on: {pad: 1}
      # the end""";

  private static final String FLOW =
      """
      {name: Flow, # all in braces
       obstacles: [
         {box: {at: [100, 0], size: [50, 50, 50]}}, # a
         {cylinder: {at: [-100, 0], radius: 10, height: 100}},
         # before the last
         {gate: {at: [0, 100], shape: frame, width: 90, height: 90, centre: 100}} # c
       ],
       pads: [{id: 2, at: [0, -100]}, {id: 3, at: [50, -100], heading: 90},],
       wind: {speed: 50, towards: 90,},
       drones: [ { start: [ 0 , 0 ] } ] }
      """;

  private static final String CRLF = "\uFEFF" + BLOCKS.replace("\n", "\r\n");

  private static final String EMPTY = "{}\n";

  private static final String SMALL = "# 🚁 nothing but a name\nname: Übung 🚁 # ok";

  private static final String UNNAMED =
      """
      obstacles:
        - gate: {at: [100, 0], shape: ring, diameter: 80, centre: 100}   # 1
        - gate: {at: [0, 100], shape: ring, diameter: 80, centre: 100}   # 2

        - wall: {from: [-100, -100], to: [-200, -175], height: 80}       # 3
        - wall: {from: [-100, 100], to: [-200, 175], height: 80}         # 4
        - box: {at: [0, -100], size: [20, 20, 20], heading: -90}         # 5
        - box: {at: [50, -100], size: [20, 20, 20], heading: 12.5}       # 6
      goals:
        - pass: {gate: gate 2}
      """;

  /**
   * A comment that is not marked as inside an item. A number sign inside a word, such as a colour,
   * does not begin a comment.
   */
  private static final Pattern COMMENT = Pattern.compile("(?<=\\s|^)(#(?!in ).*)");

  @Test
  void eachEditChangesOnlyTheLinesOfItsItem() throws Exception {
    List<ScenarioDocument> documents = new ArrayList<>();
    for (String name : Gallery.NAMES) {
      documents.add(Gallery.open(name).orElseThrow());
    }
    for (String text : List.of(BLOCKS, FLOW, CRLF, EMPTY, SMALL, UNNAMED)) {
      documents.add(document(text));
    }
    SplittableRandom random = new SplittableRandom(17);
    int done = 0;
    for (int i = 0; done < EDITS; i++) {
      ScenarioDocument document = documents.get(i % documents.size());
      for (int j = 0; j < EDITS_OF_ONE; j++) {
        RandomEdit edit = RandomEdit.of(document.scenario(), random);
        document = checked(document, edit);
        done += edit.what().equals("nothing") ? 0 : 1;
      }
    }
  }

  private static ScenarioDocument checked(ScenarioDocument before, RandomEdit edit) {
    ScenarioDocument after = before.changedTo(edit.changed(), Path.of(""));
    String old = text(before);
    String now = text(after);
    String what = edit.what() + " in\n" + old + "\ngave\n" + now;
    assertThat(after.kept()).as(what).isEqualTo(Preserved.ALL);
    ParsedScenario read =
        ScenarioFile.understood(now.replace("\uFEFF", ""), Path.of(""), CourseDraw.NONE)
            .orElseThrow();
    assertSame(read.scenario(), edit.changed(), what);
    List<String> oldLines = lines(old);
    List<String> newLines = lines(now);
    int common = common(oldLines, newLines);
    assertThat(oldLines.size() - common).as(what).isLessThanOrEqualTo(edit.linesGone());
    assertThat(newLines.size() - common).as(what).isLessThanOrEqualTo(edit.linesNew());
    if (!edit.what().startsWith("remove")) {
      assertThat(comments(now)).as(what).isEqualTo(comments(old));
    }
    return after;
  }

  /**
   * Asserts equality except for generated names, and for 10 µm, to which the ends of walls are
   * rounded.
   */
  private static void assertSame(Scenario read, Scenario wanted, String what) {
    List<Obstacle> found = read.config().arena().obstacles();
    List<Obstacle> obstacles = wanted.config().arena().obstacles();
    assertThat(found).as(what).hasSameSizeAs(obstacles);
    List<Obstacle> named = new ArrayList<>();
    for (int i = 0; i < found.size(); i++) {
      Obstacle each = found.get(i);
      String name = obstacles.get(i).name();
      boolean given = each.name().contains(" ") && name.contains(" ");
      named.add(
          new Obstacle(
              given ? name : each.name(),
              each.shape(),
              each.foot(),
              each.heading(),
              each.appearance()));
    }
    SimConfig config = read.config().withArena(read.config().arena().withObstacles(named));
    if (written(read.withConfig(config)).equals(written(wanted))) {
      return; // the comparison is slow
    }
    assertThat(new Content(config, read.challenge(), read.stations()))
        .as(what)
        .usingRecursiveComparison()
        .withComparatorForType(
            (a, b) -> Math.abs(a - b) < 1.1e-5 ? 0 : Double.compare(a, b), Double.class)
        .isEqualTo(new Content(wanted.config(), wanted.challenge(), wanted.stations()));
  }

  private static String written(Scenario scenario) {
    return text(ScenarioDocument.of(scenario).changedTo(scenario, Path.of("")));
  }

  private record Content(
      SimConfig config, Challenge challenge, List<Scenario.CommandAddress> stations) {}

  private static List<String> lines(String text) {
    return Arrays.asList(text.split("(?<=\n)", -1));
  }

  private static List<String> comments(String text) {
    return COMMENT.matcher(text).results().map(match -> match.group(1)).toList();
  }

  /** Returns the length of the longest common subsequence. */
  private static int common(List<String> a, List<String> b) {
    int[][] length = new int[a.size() + 1][b.size() + 1];
    for (int i = 1; i <= a.size(); i++) {
      for (int j = 1; j <= b.size(); j++) {
        length[i][j] =
            a.get(i - 1).equals(b.get(j - 1))
                ? length[i - 1][j - 1] + 1
                : Math.max(length[i - 1][j], length[i][j - 1]);
      }
    }
    return length[a.size()][b.size()];
  }

  private static ScenarioDocument document(String text) {
    String unmarked = text.replace("\uFEFF", "");
    Optional<ParsedScenario> noted =
        ScenarioFile.understood(unmarked, Path.of(""), CourseDraw.NONE);
    return ScenarioDocument.read(noted.orElseThrow(), text, Path.of(""), CourseDraw.NONE);
  }

  private static String text(ScenarioDocument document) {
    return new String(document.bytes().orElseThrow(), StandardCharsets.UTF_8);
  }
}
