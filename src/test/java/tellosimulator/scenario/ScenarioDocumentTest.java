package tellosimulator.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;
import org.junit.jupiter.params.provider.ValueSource;
import tellosimulator.goal.Goal;
import tellosimulator.math.Vec3;
import tellosimulator.scenario.ScenarioDocument.Preserved;
import tellosimulator.sim.SimConfig;
import tellosimulator.world.Arena;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.Room;
import tellosimulator.world.Shape;
import tellosimulator.world.Wind;

/** Tests which parts of a text are preserved when its scenario changes. */
class ScenarioDocumentTest {

  static final List<String> GALLERY = Gallery.NAMES;

  @TempDir private Path folder;

  @ParameterizedTest
  @FieldSource("GALLERY")
  void aScenarioOfTheProgramIsSavedByteByByte(String name) throws Exception {
    byte[] original;
    try (InputStream input = Gallery.class.getResourceAsStream(name + ".yaml")) {
      original = input.readAllBytes();
    }
    ScenarioDocument document = Gallery.open(name).orElseThrow();
    Path file = folder.resolve(name + ".yaml");

    ScenarioFile.write(document.changedTo(document.scenario(), folder), file);

    assertThat(Files.readAllBytes(file)).isEqualTo(original);
  }

  @Test
  void aMovedBoxChangesItsLineAlone() throws Exception {
    String text =
        """
        # yaml-language-server: $schema=scenario.schema.json
        name: 'Course'   # of the first lesson

        obstacles:
            # the desk
            - box: {name: desk, at: [ 100.0,50 ], size: [60, 120.50, 75], colour: brown} # mine
            - wall: {from: [0, -100], to: [0, 100], height: 150, colour: "#AABBCC"}
        drones: [{start: [-100, -100]}]
        seed:   7
        """;

    assertThat(changed(text, obstacle("desk", moved(0.05, 0))))
        .isEqualTo(text.replace("[ 100.0,50 ], size: [60, 120.50", "[105, 50], size: [60, 120.5"));
    assertThat(changed(text, obstacle("wall 1", moved(0.05, -0.1))))
        .isEqualTo(
            text.replace("[0, -100]", "[5, -110]")
                .replace("[0, 100]", "[5, 90]")
                .replace("#AABBCC", "#aabbcc"));
  }

  @Test
  void numbersColorsAndWhatIsLeftOutStayInOtherEntries() throws Exception {
    String text =
        """
        room: {height: 2.5e2, depth: 600.00} # of the school
        drones: [{start: [+100, -0], battery: 055, colour: red}]
        time-limit: 90.0
        touch: "forbidden"
        """;

    assertThat(changed(text, arena(a -> a.withRoom(new Room(5, 6, 3)))))
        .isEqualTo(
            text.replace("height: 2.5e2, depth: 600.00", "width: 500, depth: 600, height: 300"));
    assertThat(changed(text, arena(a -> a.withDecor(a.decor().withGrid(0.2)))))
        .isEqualTo(text.replace("school\n", "school\ngrid: 20\n"));
  }

  @Test
  void textsInSeveralLanguagesStay() throws Exception {
    String text =
        """
        name: {de: 'Kurs',  en: Course, fr: Parcours}
        teaches:
            en: "to aim"   # and not more
            de: zu zielen
        difficulty: hard
        room: {height: 250}
        """;

    assertThat(changed(text, arena(a -> a.withRoom(new Room(5, 5, 3)))))
        .isEqualTo(text.replace("height: 250", "width: 500, depth: 500, height: 300"));
  }

  @Test
  void aNewObstacleIsWrittenInOneLine() throws Exception {
    Obstacle box =
        new Obstacle(
            "box-1",
            new Shape.Box(0.5, 0.5, 0.5),
            new Vec3(1, 1, 0),
            0,
            ObstacleAppearance.DEFAULT);

    assertThat(
            changed(
                """
                obstacles:
                - cylinder:
                      at: [0, 0]   # the middle
                      radius: 5
                      height: 100 # [cm]
                # - box: {at: [0, 0], size: [1, 1, 1]}

                drones: [{start: [-100, 0]}]
                """,
                adding(box)))
        .isEqualTo(
            """
            obstacles:
            - cylinder:
                  at: [0, 0]   # the middle
                  radius: 5
                  height: 100 # [cm]
            - box: {name: box-1, at: [100, 100], size: [50, 50, 50]}
            # - box: {at: [0, 0], size: [1, 1, 1]}

            drones: [{start: [-100, 0]}]
            """);
    assertThat(changed("obstacles: []\n", adding(box)))
        .isEqualTo("obstacles: [{box: {name: box-1, at: [100, 100], size: [50, 50, 50]}}]\n");
    assertThat(changed("{} # nothing", adding(box)))
        .isEqualTo(
            "{obstacles: [{box: {name: box-1, at: [100, 100], size: [50, 50, 50]}}]} # nothing");
    assertThat(changed("name: a # b\n\nseed: 3", adding(box)))
        .isEqualTo(
            """
            name: a # b

            obstacles:
              - box: {name: box-1, at: [100, 100], size: [50, 50, 50]}

            seed: 3""");
    assertThat(
            changed(
                """
                obstacles: [
                  {cylinder: {at: [0, 200], radius: 5, height: 100}}, # left
                  {cylinder: {at: [0, -200], radius: 5, height: 100}} # right
                ]
                """,
                adding(box)))
        .isEqualTo(
            """
            obstacles: [
              {cylinder: {at: [0, 200], radius: 5, height: 100}}, # left
              {cylinder: {at: [0, -200], radius: 5, height: 100}}, # right
              {box: {name: box-1, at: [100, 100], size: [50, 50, 50]}}
            ]
            """);
  }

  @Test
  void whatIsTakenAwayTakesItsCommentsWithIt() throws Exception {
    String text =
        """
        pads:   # four of eight
          # where one starts
          - {id: 1, at: [0, 0]}

          # - {id: 3, at: [100, 0]}
          # on the left
          # of the room
          - {id: 2, at: [0, 100]} # turned?

          - {id: 4, at: [0, -100]}
        # the drones
        drones: [{start: [0, 0]}]
        """;

    assertThat(changed(text, withoutPad(2)))
        .isEqualTo(
            """
            pads:   # four of eight
              # where one starts
              - {id: 1, at: [0, 0]}

              # - {id: 3, at: [100, 0]}

              - {id: 4, at: [0, -100]}
            # the drones
            drones: [{start: [0, 0]}]
            """);
    assertThat(changed(text, arena(a -> a.withPads(List.of()))))
        .isEqualTo(
            """
            pads: []   # four of eight

              # - {id: 3, at: [100, 0]}

            # the drones
            drones: [{start: [0, 0]}]
            """);
    assertThat(changed("pads: [{id: 1, at: [0, 0]}, {id: 2, at: [0, 100]}]", withoutPad(1)))
        .isEqualTo("pads: [{id: 2, at: [0, 100]}]");
    assertThat(changed("pads: [{id: 1, at: [0, 0]}, {id: 2, at: [0, 100]}]", withoutPad(2)))
        .isEqualTo("pads: [{id: 1, at: [0, 0]}]");
    assertThat(changed("pads: [{id: 1, at: [0, 0]},]  # one", withoutPad(1)))
        .isEqualTo("pads: []  # one");
    MissionPad third = MissionPad.onFloor(3, new Vec3(1, 0, 0), 0);
    assertThat(changed("pads: [{id: 1, at: [0, 0]},]", arena(a -> a.withPads(List.of(third)))))
        .isEqualTo("pads: [{id: 3, at: [100, 0]},]");
  }

  @Test
  void lineEndsByteOrderMarkAndMissingLastLineEndStay() throws Exception {
    String text =
        "\uFEFFname: Gerät\t# 🚁\r\npads:\r\n- {id: 1, at: [0, 0]}\r\n- {id: 2, at: [0, 50]}";

    assertThat(changed(text, withoutPad(2)))
        .isEqualTo("\uFEFFname: Gerät\t# 🚁\r\npads:\r\n- {id: 1, at: [0, 0]}");
    assertThat(
            changed(
                text,
                arena(
                    a ->
                        a.withPads(
                            List.of(
                                a.pads().get(0),
                                a.pads().get(1),
                                MissionPad.onFloor(3, new Vec3(1, 1, 0), 0))))))
        .isEqualTo(text + "\r\n- {id: 3, at: [100, 100]}");
  }

  @Test
  void whatBecomesUsualIsLeftOut() throws Exception {
    assertThat(
            changed(
                "wind: {speed: 100, gusts: 20} # from behind\n", arena(a -> a.withWind(Wind.CALM))))
        .isEqualTo("wind: {} # from behind\n");
    assertThat(
            changed(
                "pads: [{id: 1, heading: 90, at: [0, 0]}]\n",
                arena(a -> a.withPads(List.of(MissionPad.onFloor(1, Vec3.ZERO, 0))))))
        .isEqualTo("pads: [{id: 1, at: [0, 0]}]\n");
  }

  @Test
  void aGateKeepsTheNameByWhichAGoalCallsIt() throws Exception {
    String text =
        """
        obstacles:
          - gate: {at: [100, 0], shape: ring, diameter: 80, centre: 100}
          - gate: {at: [0, 100], shape: ring, diameter: 80, centre: 100}
          - gate: {at: [0, -100], shape: ring, diameter: 80, centre: 100}
        goals:
          - pass: {gate: gate 2}
        """;

    assertThat(changed(text, without("gate 1")))
        .isEqualTo(
            """
            obstacles:
              - gate: {name: gate 2, at: [0, 100], shape: ring, diameter: 80, centre: 100, thickness: 5}
              - gate: {name: gate 3, at: [0, -100], shape: ring, diameter: 80, centre: 100, thickness: 5}
            goals:
              - pass: {gate: gate 2}
            """);
    assertThat(changed(text, without("gate 3"))).isEqualTo(withoutLine(text, 4));
  }

  @Test
  void aValueThatIsUsedTwiceIsChangedOnlyOnce() throws Exception {
    String text =
        """
        # two alike
        obstacles:
          - box: {name: a, at: [100, 0], size: &s [50, 50, 50]}
          - box: {name: b, at: [-100, 0], size: *s}
        seed: 5 # mine
        drones: [{start: [0, 100]}]
        """;
    assertThat(changed(text, obstacle("b", resized(0.6))))
        .isEqualTo(text.replace("*s", "[60, 50, 50]"));

    ScenarioDocument document = read(text);
    ScenarioDocument changed =
        document.changedTo(obstacle("a", resized(0.6)).apply(document.scenario()), folder);
    assertThat(changed.kept()).isEqualTo(Preserved.SECTIONS);
    assertThat(text(changed))
        .startsWith("# two alike\nobstacles:\n  - box: {name: a, at: [100, 0], size: [60, 50, 50]}")
        .endsWith("\nseed: 5 # mine\ndrones: [{start: [0, 100]}]\n");
  }

  @Test
  void commentsInsideAChangedItemGoAndAllOthersStay() throws Exception {
    String text =
        """
        obstacles:   # from the left
          # the desk
          - box:
              # of oak
              name: desk
              at: [100, 50]   # [cm]
              size: [60, 120, 75]   # with drawers
              # end of the desk
          #\tbetween\tthem

          -   box:\t\t# of pine
                name: crate\t# one of two
                at: [0.0, -50]
                size: [50, 50, 50]
        # the drones
        drones: [{start: [-100, -100]}]
        """;

    assertThat(changed(text, obstacle("desk", moved(0.05, 0))))
        .isEqualTo(
            """
            obstacles:   # from the left
              # the desk
              - box: {name: desk, at: [105, 50], size: [60, 120, 75]}   # with drawers
                  # end of the desk
              #\tbetween\tthem

              -   box:\t\t# of pine
                    name: crate\t# one of two
                    at: [0.0, -50]
                    size: [50, 50, 50]
            # the drones
            drones: [{start: [-100, -100]}]
            """);
    assertThat(changed(text, obstacle("crate", moved(0.05, 0))))
        .isEqualTo(
            text.substring(0, text.indexOf("box:\t\t#"))
                + "box: {name: crate, at: [5, -50], size: [50, 50, 50]}\n"
                + text.substring(text.indexOf("# the drones")));
  }

  @Test
  void itemsAndTheirCommentsAreReordered() throws Exception {
    String text =
        """
        pads:
          # first
          - {id: 1, at: [0.0, 0]} # a
          - {id: 2, at: [0.0, 100]} # b

          # third
          - {id: 3, at: [0.0, -100]}
        seed: 5
        """;

    assertThat(changed(text, pads(3, 1, 2)))
        .isEqualTo(
            """
            pads:

              # third
              - {id: 3, at: [0.0, -100]}
              # first
              - {id: 1, at: [0.0, 0]} # a
              - {id: 2, at: [0.0, 100]} # b
            seed: 5
            """);
    assertThat(changed("pads: [{id: 1, at: [0.0, 0]},  {id: 2, at: [0, 50.0]} ]", pads(2, 1)))
        .isEqualTo("pads: [{id: 2, at: [0, 50.0]},  {id: 1, at: [0.0, 0]} ]");
  }

  @Test
  void whatIsRemovedAndAddedElsewhereDoesNotTouchTheItemsBetween() throws Exception {
    String text =
        """
        pads: [
          {id: 1, at: [0.0, 0]}, # a
          # on its own

          {id: 2, at: [0.0, 100]}, # b
          {id: 3, at: [0.0, -100]}  # c
        ]
        """;
    MissionPad fourth = MissionPad.onFloor(4, new Vec3(1, 0, 0), 0);

    assertThat(
            changed(
                text, arena(a -> a.withPads(List.of(a.pads().get(1), a.pads().get(2), fourth)))))
        .isEqualTo(
            """
            pads: [
              # on its own

              {id: 2, at: [0.0, 100]}, # b
              {id: 3, at: [0.0, -100]},  # c
              {id: 4, at: [100, 0]}
            ]
            """);
  }

  @Test
  void anAliasInAListMakesTheCodecWriteTheList() throws Exception {
    String text =
        """
        pads: [{id: 1, at: [0, 0]}] # card
        # same
        goals:
          # twice
          - &g {land-on: {pad: 1}}
          - *g
        seed: 5 # mine
        """;

    assertThat(changed(text, scenario -> scenario)).isEqualTo(text);
    assertThat(changed(text, arena(a -> a.withRoom(new Room(6, 5, 3)))))
        .isEqualTo("room: {width: 600, depth: 500, height: 300}\n" + text);
    assertThat(
            changed(
                text,
                scenario -> {
                  List<Goal> goals = scenario.challenge().goals();
                  return scenario.withChallenge(
                      scenario.challenge().withGoals(goals.subList(0, 1)));
                }))
        .isEqualTo(
            """
            pads: [{id: 1, at: [0, 0]}] # card
            # same
            goals:
              - land-on: {pad: 1}
            seed: 5 # mine
            """);
  }

  /** Rare forms of YAML. Each is changed in several places; only comments may be lost. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "? pads\n: - {id: 1, at: [0, 0]}\n  - {id: 2, at: [0, 100]}\n? seed\n: 5\n",
        "pads: &p\n- &a {id: 1, at: &o [0, 0]}\n-\n   # x\n   id: 2\n   at: [0, 100]\nseed: 5",
        "pads: !!seq\n  - !!map {id: 1, at: [0, 0]}\n  - ? id\n    : 2\n    at:\n    - 0\n    - 100\n",
        "%YAML 1.2\n---\npads:\n  - id: 1\n    at: [0,\n # x\n 0]\n  - {id: 2, at: [0, 100]}\n...\n",
        "name: |-\n  # no comment\n\npads: [\n\t{id: 1, at: [0, 0]} ,\n\t{id: 2, at: [0, 100]}\t# x\n]\n",
        "{\"pads\":[{\"id\":1,\"at\":[0,0]},{\"id\":2,\"at\":[0,100]}],\"seed\":5}",
        "{ # x, y\n  pads: [{id: 1, at: [0, 0]}, # a, b\n   {id: 2, at: [0, 100]},\n  ], # c\n  seed: 5,\n}\n",
        "pads:\r\n  - {id: 1, at: [0, 0]}\n  - {id: 2, at: [0, 100]}\r\nname: >\n  a\n  b\n\n",
        "pads:\n  - id: &i 1\n    at: [0, &o 0]\n  - id: 2\n    at:\n    - *o\n    - 100\n  # x\nseed: *i\n",
        "--- # x\n  pads:\n  - &a {id: 1, at: [0, 0]}\n  - {id: 2, at: [0, 100]}\n  posters: []\n"
      })
  void rareFormsOfYamlAreSaved(String text) throws Exception {
    ScenarioDocument document = read(text);
    MissionPad third = MissionPad.onFloor(3, new Vec3(1, 0, 0), 0);
    List<UnaryOperator<Scenario>> changes =
        List.of(
            withoutPad(1),
            withoutPad(2),
            pads(),
            pads(2, 1),
            arena(a -> a.withPads(List.of(a.pads().get(0), third, a.pads().get(1)))),
            arena(a -> a.withPads(List.of(a.pads().get(0), third))),
            arena(a -> a.withPads(List.of(third))),
            arena(a -> a.withRoom(new Room(5, 6, 3))),
            arena(a -> a.withWind(new Wind(new Vec3(1, 0, 0), 0.5))),
            scenario -> scenario);
    for (UnaryOperator<Scenario> change : changes) {
      Scenario wanted = change.apply(document.scenario());

      ScenarioDocument changed = document.changedTo(wanted, folder);

      assertThat(read(text(changed)).scenario()).as(text(changed)).isEqualTo(wanted);
    }
    assertThat(text(document.changedTo(document.scenario(), folder))).isEqualTo(text);
  }

  @Test
  void anUnnamedObstacleThatIsRenamedKeepsItsForm() throws Exception {
    String text =
        """
        obstacles:
          # low
          - wall: {from: [100, -100], to: [100, 100], height: 150}
        """;

    assertThat(changed(text, obstacle("wall 1", wall -> wall.named("fence"))))
        .isEqualTo(text.replace("{from", "{name: fence, from"));
  }

  @Test
  void aTurnedWallStaysAWall() throws Exception {
    String text = "obstacles: [{wall: {from: [150, -50], to: [150, 50], height: 150}}]";
    ScenarioDocument document = read(text);
    Obstacle wall = document.scenario().config().arena().obstacles().get(0);
    UnaryOperator<Scenario> turned = obstacle("wall 1", w -> w.movedTo(w.foot(), Math.PI / 2));

    String changed = changed(text, turned);

    assertThat(changed)
        .isEqualTo("obstacles: [{wall: {from: [200, 0], to: [100, 0], height: 150}}]");
    Obstacle read = read(changed).scenario().config().arena().obstacles().get(0);
    assertThat(read).isEqualTo(wall.movedTo(wall.foot(), Math.PI / 2));
  }

  @Test
  void picturesAreNamedFromTheFolderOfTheNewFile() throws Exception {
    Files.createFile(folder.resolve("face.png"));
    String text =
        """
        posters:
          - {wall: front, along: 0, height: 120, width: 30, picture: face.png} # who is it?
        """;
    Path elsewhere = Files.createDirectory(folder.resolve("copies"));
    ScenarioDocument document = read(text);

    ScenarioDocument moved = document.changedTo(document.scenario(), elsewhere);

    assertThat(text(moved)).isEqualTo(text.replace("face.png", "\"../face.png\""));
    Files.delete(folder.resolve("face.png"));
    assertThat(text(document.changedTo(document.scenario(), folder))).isEqualTo(text);
  }

  // --- changes ---

  static UnaryOperator<Scenario> arena(UnaryOperator<Arena> change) {
    return scenario -> {
      SimConfig config = scenario.config();
      return scenario.withConfig(config.withArena(change.apply(config.arena())));
    };
  }

  static UnaryOperator<Scenario> obstacle(String name, UnaryOperator<Obstacle> change) {
    return arena(
        a ->
            a.withObstacles(
                a.obstacles().stream()
                    .map(each -> each.name().equals(name) ? change.apply(each) : each)
                    .toList()));
  }

  private static UnaryOperator<Scenario> without(String name) {
    return arena(
        a ->
            a.withObstacles(
                a.obstacles().stream().filter(each -> !each.name().equals(name)).toList()));
  }

  private static UnaryOperator<Scenario> withoutPad(int id) {
    return arena(a -> a.withPads(a.pads().stream().filter(pad -> pad.id() != id).toList()));
  }

  /** Returns a change after which the pads with these numbers are in this order. */
  private static UnaryOperator<Scenario> pads(int... ids) {
    return arena(
        a ->
            a.withPads(
                Arrays.stream(ids)
                    .mapToObj(
                        id ->
                            a.pads().stream().filter(pad -> pad.id() == id).findAny().orElseThrow())
                    .toList()));
  }

  static UnaryOperator<Scenario> adding(Obstacle obstacle) {
    return arena(
        a -> {
          List<Obstacle> more = new ArrayList<>(a.obstacles());
          more.add(obstacle);
          return a.withObstacles(more);
        });
  }

  private static UnaryOperator<Obstacle> moved(double x, double y) {
    return each -> each.movedTo(each.foot().plus(new Vec3(x, y, 0)), each.heading());
  }

  private static UnaryOperator<Obstacle> resized(double depth) {
    return each -> {
      Shape.Box box = (Shape.Box) each.shape();
      Shape.Box other = new Shape.Box(depth, box.width(), box.height());
      return new Obstacle(each.name(), other, each.foot(), each.heading(), each.appearance());
    };
  }

  private static String withoutLine(String text, int number) {
    List<String> lines = new ArrayList<>(text.lines().toList());
    lines.remove(number - 1);
    return String.join("\n", lines) + "\n";
  }

  /** Returns the text after a change that preserves the whole text. */
  private String changed(String text, UnaryOperator<Scenario> change) throws Exception {
    ScenarioDocument document = read(text);
    ScenarioDocument changed = document.changedTo(change.apply(document.scenario()), folder);
    assertThat(changed.kept()).as("what stays of%n%s", text(changed)).isEqualTo(Preserved.ALL);
    return text(changed);
  }

  private ScenarioDocument read(String text) throws IOException, ScenarioException {
    return ScenarioFile.open(Files.writeString(folder.resolve("read.yaml"), text));
  }

  private static String text(ScenarioDocument document) {
    return new String(document.bytes().orElseThrow(), StandardCharsets.UTF_8);
  }
}
