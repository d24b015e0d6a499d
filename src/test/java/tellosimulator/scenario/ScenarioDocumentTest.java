package tellosimulator.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.FieldSource;
import tellosimulator.math.Vec3;
import tellosimulator.scenario.ScenarioDocument.Kept;
import tellosimulator.sim.SimConfig;
import tellosimulator.world.Arena;
import tellosimulator.world.MissionPad;
import tellosimulator.world.Obstacle;
import tellosimulator.world.ObstacleAppearance;
import tellosimulator.world.Room;
import tellosimulator.world.Shape;
import tellosimulator.world.Wind;

/** What stays of a text when the scenario that it says is changed. */
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
        .isEqualTo(text.replace("[ 100.0,50 ]", "[ 105,50 ]"));
    assertThat(changed(text, obstacle("wall 1", moved(0.05, -0.1))))
        .isEqualTo(text.replace("[0, -100]", "[5, -110]").replace("[0, 100]", "[5, 90]"));
  }

  @Test
  void numbersColorsAndWhatIsLeftOutStay() throws Exception {
    String text =
        """
        room: {height: 2.5e2, depth: 600.00}
        drones: [{start: [+100, -0], battery: 055, colour: red}]
        time-limit: 90.0
        touch: "forbidden"
        """;

    assertThat(changed(text, arena(a -> a.withRoom(new Room(5, 6, 3)))))
        .isEqualTo(text.replace("2.5e2", "300"));
    assertThat(changed(text, arena(a -> a.withRoom(new Room(4, 6, 2.5)))))
        .isEqualTo(text.replace("{height", "{width: 400, height"));
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
        .isEqualTo(text.replace("250", "300"));
  }

  @Test
  void aNewObstacleIsWrittenLikeItsNeighbors() throws Exception {
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
            - box:
                  name: box-1
                  at: [100, 100]
                  size: [50, 50, 50]
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
        .isEqualTo("pads: [{id: 3, at: [100, 0]}]");
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
  void whatBecomesUsualIsSaidWhereItWasSaid() throws Exception {
    assertThat(
            changed(
                "wind: {speed: 100, gusts: 20} # from behind\n", arena(a -> a.withWind(Wind.CALM))))
        .isEqualTo("wind: {speed: 0, gusts: 0} # from behind\n");
    assertThat(
            changed(
                "pads: [{id: 1, heading: 90, at: [0, 0]}]\n",
                arena(a -> a.withPads(List.of(MissionPad.onFloor(1, Vec3.ZERO, 0))))))
        .isEqualTo("pads: [{id: 1, heading: 0, at: [0, 0]}]\n");
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
              - gate: {name: gate 2, at: [0, 100], shape: ring, diameter: 80, centre: 100}
              - gate: {at: [0, -100], shape: ring, diameter: 80, centre: 100}
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
    assertThat(changed.kept()).isEqualTo(Kept.SECTIONS);
    assertThat(text(changed))
        .startsWith("# two alike\nobstacles:\n  - box: {name: a, at: [100, 0], size: [60, 50, 50]}")
        .endsWith("\nseed: 5 # mine\ndrones: [{start: [0, 100]}]\n");
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
          - {wall: front, height: 120, width: 30, picture: face.png} # who is it?
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

  /** The text after a change that keeps all of it. */
  private String changed(String text, UnaryOperator<Scenario> change) throws Exception {
    ScenarioDocument document = read(text);
    ScenarioDocument changed = document.changedTo(change.apply(document.scenario()), folder);
    assertThat(changed.kept()).as("what stays of%n%s", text(changed)).isEqualTo(Kept.ALL);
    return text(changed);
  }

  private ScenarioDocument read(String text) throws IOException, ScenarioException {
    return ScenarioFile.open(Files.writeString(folder.resolve("read.yaml"), text));
  }

  private static String text(ScenarioDocument document) {
    return new String(document.bytes().orElseThrow(), StandardCharsets.UTF_8);
  }
}
