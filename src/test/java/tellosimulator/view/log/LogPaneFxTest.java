package tellosimulator.view.log;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.testing.SteppedDrone.address;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import atlantafx.base.theme.PrimerLight;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.OptionalInt;
import java.util.Set;
import java.util.concurrent.Callable;
import javafx.application.Application;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Label;
import javafx.scene.control.ListCell;
import javafx.scene.control.ListView;
import javafx.scene.control.TextArea;
import javafx.scene.control.TextField;
import javafx.scene.control.ToggleButton;
import javafx.scene.input.Clipboard;
import javafx.scene.input.KeyCode;
import javafx.scene.input.ScrollEvent;
import javafx.stage.Stage;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.ExtendWith;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import org.testfx.framework.junit5.Start;
import org.testfx.util.WaitForAsyncUtils;
import tellosimulator.command.Peer;
import tellosimulator.command.Reply;
import tellosimulator.command.Request;
import tellosimulator.controller.FlightEvent;
import tellosimulator.math.Vec3;
import tellosimulator.network.AddressPlan;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.sim.Formation;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimEvent;
import tellosimulator.time.SimTime;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.testing.QuickRobot;
import tellosimulator.view.testing.StageExtension;
import tellosimulator.view.testing.ViewContexts;
import tellosimulator.view.testing.WindowFixture;
import tellosimulator.view.text.Language;
import tellosimulator.view.video.MediaFolder;
import tellosimulator.view.video.WindowVideo;
import tellosimulator.words.Phrase;
import tellosimulator.world.Room;
import tellosimulator.world.Surface;

@ExtendWith(StageExtension.class)
class LogPaneFxTest {

  /** Maximum number of cells in a list of this height, and a few that the toolkit keeps. */
  private static final int MOST_CELLS = 40;

  private final LogQueue logQueue = new LogQueue();
  private final FxRobot robot = new QuickRobot();
  private OnlineSimulation simulation;
  private ViewContext context;
  private LogPane box;

  @Start
  void start(Stage stage) {
    Application.setUserAgentStylesheet(new PrimerLight().getUserAgentStylesheet());
    simulation =
        new OnlineSimulation(
            SimConfig.DEFAULT.withRoom(Room.DEFAULT, Formation.row(2, Vec3.ZERO, Room.DEFAULT)),
            AddressPlan.portPerDrone(2, List.of(address("127.0.0.1", 0).getAddress()), 0),
            OptionalInt.empty(),
            List.of());
    context =
        ViewContexts.of(
            simulation,
            new Language(Locale.ENGLISH),
            WindowVideo.of(simulation, DroneOptics.DEFAULT, MediaFolder.ofUser()));
    box = new LogPane(context, logQueue);
    stage.setScene(new Scene(box, 1280, 170));
    stage.show();
    context.ticker().tick(0);
  }

  @AfterEach
  void close() {
    context.video().close();
    simulation.close();
  }

  @Test
  void aLineShowsTimeDroneAndWordsInTheColorOfItsLevel() {
    happens(
        new SimEvent.DroneFlight(
            new SimTime(1_500_000_000),
            2,
            new FlightEvent.Crashed(Surface.CEILING, 2.04, 0, Vec3.ZERO)));

    ListCell<?> cell = cells().stream().filter(one -> one.getIndex() == 1).findFirst().get();
    assertThat(textOf(cell, ".log-time")).isEqualTo("1.500 s");
    assertThat(robot.from(cell).lookup(".log-time").queryLabeled().getTooltip().getText())
        .isEqualTo("Simulation time");
    assertThat(textOf(cell, ".log-drone")).isEqualTo("drone 2");
    assertThat(textOf(cell, ".log-words")).startsWith("crashed into the ceiling at 2.0 m/s");
    assertThat(cell.lookup(".log-error")).isNotNull();
  }

  @Test
  void theLevelFilterShowsThatLevelAndAbove() {
    commands(1);
    happens(new SimEvent.CommandReceived(SimTime.ZERO, 1, new Request(1, peer(), "battery?")));
    happens(
        new SimEvent.CommandIgnored(
            SimTime.ZERO, 1, peer(), "up 20", Phrase.of("the drone is off")));
    assertThat(shown()).as("reads are details").hasSize(3).noneMatch(w -> w.contains("battery?"));

    robot.clickOn("#log-level").clickOn("Everything");
    assertThat(shown()).hasSize(4).anyMatch(words -> words.contains("battery?"));

    robot.clickOn("#log-level").clickOn("Warnings and errors");
    assertThat(shown()).singleElement().asString().startsWith("`up 20` from");
  }

  @Test
  void aCommandItsReplyAndHowLongItTookAreOneRow() {
    happens(
        new SimEvent.CommandReceived(
            new SimTime(2_000_000_000), 1, new Request(1, peer(), "takeoff")));
    assertThat(textOf(cell(1), ".log-words")).isEqualTo("takeoff");
    assertThat(textOf(cell(1), ".log-reply")).isEqualTo("…");

    happens(
        new SimEvent.ReplySent(
            new SimTime(5_250_000_000L), 1, new Request(1, peer(), "takeoff"), Reply.OK));

    assertThat(shown()).as("a greeting and the command").hasSize(2);
    assertThat(textOf(cell(1), ".log-reply")).isEqualTo("ok");
    assertThat(textOf(cell(1), ".log-duration")).as("5.25 s - 2 s").isEqualTo("3.25 s");
    assertThat(cell(1).getAccessibleText()).isEqualTo("drone 1 takeoff ok 3.25 s");
  }

  @Test
  void aRefusedCommandSaysWhyInTheColorOfAWarning() {
    refused();

    assertThat(textOf(cell(1), ".log-reply")).isEqualTo("error Not joystick");
    assertThat(textOf(cell(1), ".log-reason")).isEqualTo("something else runs");
    assertThat(cell(1).lookup(".log-warn")).isNotNull();
  }

  @Test
  void aClickOnARowShowsAllItsLinesAndAnotherOneHidesThem() {
    refused();
    TextArea details = robot.lookup("#log-details").query();
    assertThat(details.isVisible()).isFalse();

    robot.clickOn(cell(1).lookup(".log-words"));
    assertThat(details.getText().lines())
        .containsExactly(
            "1.000 s  drone 1 `up 20` from 127.0.0.1:9000",
            "1.500 s  drone 1 `up 20` refused: something else runs;"
                + " answered `error Not joystick`");

    robot.clickOn(cell(1).lookup(".log-words"));
    assertThat(details.isVisible()).isFalse();
  }

  @Test
  void enterShowsTheLinesOfTheSelectedRowAndEscapeHidesThem() {
    refused();
    robot.interact(() -> list().requestFocus());
    robot.interact(() -> list().getSelectionModel().select(1));
    TextArea details = robot.lookup("#log-details").query();

    robot.type(KeyCode.ENTER);
    assertThat(details.getText()).contains("refused");
    robot.type(KeyCode.UP);
    assertThat(details.getText()).as("follows the selection").contains("Welcome");
    robot.type(KeyCode.ESCAPE);
    assertThat(details.isVisible()).isFalse();
    assertThat(list().isFocused()).isTrue();
  }

  @Test
  void linesOfOneDroneAreShownAlone() {
    commands(1);
    happens(new SimEvent.CommandReceived(SimTime.ZERO, 2, new Request(1, peer(), "land")));

    robot.clickOn("#log-drone").clickOn("Drone 2");

    assertThat(shown()).as("with what concerns all").hasSize(2);
    assertThat(shown()).last().asString().startsWith("`land`");
    robot.clickOn("#log-drone").clickOn("All drones");
    assertThat(shown()).hasSize(3);
  }

  @Test
  void foldedItIsItsNewestLine() {
    commands(2);
    double before = box.prefHeight(-1);

    robot.clickOn("#log-fold");
    assertThat(list().getParent().isVisible()).isFalse();
    assertThat(box.prefHeight(-1)).isLessThan(before).isLessThan(40);
    assertThat(folded()).isEqualTo("forward 1");
    happens(new SimEvent.DroneFlight(SimTime.ZERO, 1, new FlightEvent.Landed(Surface.FLOOR)));
    assertThat(folded()).contains("landed");
    robot.interact(box::clear);
    assertThat(robot.lookup(".log-folded").query().lookup(".log-words").getParent().isVisible())
        .isFalse();

    robot.type(KeyCode.SPACE);
    assertThat(list().getParent().isVisible()).as("the button has the focus").isTrue();
    assertThat(list().isFocused()).isTrue();
  }

  private String folded() {
    return textOf(robot.lookup(".log-folded").query(), ".log-words");
  }

  private void refused() {
    happens(
        new SimEvent.CommandReceived(
            new SimTime(1_000_000_000), 1, new Request(1, peer(), "up 20")));
    happens(
        new SimEvent.CommandRefused(
            new SimTime(1_500_000_000),
            1,
            new Request(1, peer(), "up 20"),
            Reply.NOT_JOYSTICK,
            Phrase.of("something else runs")));
  }

  private ListCell<?> cell(int index) {
    return cells().stream().filter(one -> one.getIndex() == index).findFirst().orElseThrow();
  }

  @Test
  void timeStampsCanBeHidden() {
    commands(1);
    assertThat(timeStamps()).anyMatch(Node::isVisible);

    robot.clickOn("#log-timestamps");
    assertThat(timeStamps()).isNotEmpty().noneMatch(Node::isVisible);
    robot.clickOn("#log-timestamps");
    assertThat(timeStamps()).anyMatch(Node::isVisible);
  }

  @Test
  void theNewestLineStaysInSightUntilOneScrollsUpAndAgainAtTheEnd() {
    commands(100);
    assertThat(lastVisible()).isEqualTo(100);

    wheel(100);
    assertThat(autoscroll().isSelected()).isFalse();
    List<Integer> read = visible();
    commands(50);
    assertThat(visible()).as("what one reads stands still").isEqualTo(read);

    wheel(-5000);
    assertThat(autoscroll().isSelected()).isTrue();
    commands(1);
    assertThat(lastVisible()).isEqualTo(151);
  }

  @Test
  void autoscrollCanBeSwitchedOffAndOnAgain() {
    robot.clickOn("#log-autoscroll");
    commands(100);
    assertThat(visible()).as("still at the beginning").startsWith(0);

    robot.clickOn("#log-autoscroll");
    pulse();
    assertThat(lastVisible()).isEqualTo(100);
  }

  @Test
  void draggingTheScrollBarStopsFollowing() {
    commands(100);
    robot.drag("#log-list .scroll-bar:vertical .thumb").dropBy(0, -60);
    pulse();

    waitUntil(() -> !autoscroll().isSelected());
    assertThat(lastVisible()).isLessThan(100);
  }

  @Test
  void keysScrollAwayFromTheEndAndBack() {
    commands(100);
    robot.clickOn("#log-list");
    waitUntil(() -> list().isFocused());

    robot.type(KeyCode.HOME);
    pulse();
    waitUntil(() -> !autoscroll().isSelected());
    assertThat(visible()).startsWith(0);

    robot.type(KeyCode.END);
    pulse();
    waitUntil(() -> autoscroll().isSelected());
    assertThat(lastVisible()).isEqualTo(100);
  }

  @Test
  void whatOneReadsStandsStillWhenOldLinesFallOut() {
    commands(LogModel.CAPACITY - 1);
    wheel(100);
    List<String> read = visibleWords();

    commands(3000);

    assertThat(visibleWords()).isEqualTo(read);
  }

  @Test
  void aSearchFiltersAndCountsAndCanBeCleared() {
    commands(20);
    robot.interact(box::startSearch);
    assertThat(search().isFocused()).isTrue();

    robot.write("Forward 1");
    assertThat(shown()).hasSize(11).allMatch(words -> words.contains("forward 1"));
    assertThat(matches().getText()).isEqualTo("11 lines");
    assertThat(matches().isVisible()).isTrue();

    robot.clickOn("#log-search-clear");
    assertThat(search().getText()).isEmpty();
    assertThat(shown()).hasSize(21);
    assertThat(matches().isVisible()).isFalse();
  }

  @Test
  void escapeClearsTheSearch() {
    commands(20);
    robot.clickOn("#log-search").write("nowhere");
    assertThat(shown()).isEmpty();

    robot.type(KeyCode.ESCAPE);
    assertThat(shown()).hasSize(21);
  }

  @Test
  void clearRemovesAllLinesAndNewOnesAppear() {
    commands(100);
    robot.clickOn("#log-clear");
    assertThat(shown()).isEmpty();

    commands(1);
    assertThat(shown()).hasSize(1);
  }

  @Test
  void allLinesAreCopiedIfNoneIsSelected() {
    commands(2);
    robot.clickOn("#log-copy");

    assertThat(clipboard().lines())
        .hasSize(3)
        .last()
        .isEqualTo("     0.000 s  INFO   drone 1: `forward 1` from 127.0.0.1:9000");
  }

  @Test
  void theSelectedLinesAreCopiedByKeys() {
    commands(4);
    robot.interact(() -> list().getSelectionModel().selectIndices(2, 3));
    robot.interact(() -> list().requestFocus());
    robot.push(KeyCode.SHORTCUT, KeyCode.C);

    assertThat(clipboard().lines()).hasSize(2).allMatch(line -> line.contains("`forward "));
  }

  @Test
  void theShownLinesAreSavedToAFile(@TempDir Path folder) throws IOException {
    commands(12);
    robot.clickOn("#log-search").write("forward 1");
    Path file = folder.resolve("log.txt");

    robot.interact(() -> box.save(file));
    pulse();

    assertThat(Files.readAllLines(file)).hasSize(3).allMatch(line -> line.contains("forward 1"));
    robot.type(KeyCode.ESCAPE);
    assertThat(shown()).last().asString().isEqualTo("The log was saved to " + file + ".");
  }

  @Test
  void aFileThatCannotBeWrittenIsALineOfTheLog(@TempDir Path folder) {
    Path file = folder.resolve("missing").resolve("log.txt");

    robot.interact(() -> box.save(file));
    pulse();

    assertThat(shown())
        .last()
        .asString()
        .isEqualTo(
            "The log could not be saved to " + file + ": there is no folder for " + file + ".");
  }

  @Test
  void anotherLanguageChangesControlsAndOldLines() {
    commands(1);
    assertThat(visibleWords()).first().asString().startsWith("Welcome.");

    robot.interact(() -> context.language().localeProperty().set(Locale.GERMAN));
    WindowFixture.settle();

    assertThat(visibleWords()).hasSize(2);
    assertThat(visibleWords()).first().asString().startsWith("Willkommen.");
    assertThat(visibleWords()).last().isEqualTo("forward 0");
    assertThat(robot.lookup("#log-clear").queryLabeled().getText()).isEqualTo("Leeren");
    ChoiceBox<LogLevel> levels = robot.lookup("#log-level").query();
    assertThat(levels.getConverter().toString(LogLevel.ERROR)).isEqualTo("Nur Fehler");
  }

  @Test
  void aHundredThousandLinesNeedNoMoreCellsThanFitIntoTheWindow() {
    commands(LogModel.CAPACITY);
    assertThat(list().getItems()).hasSize(LogModel.CAPACITY);
    for (int line = 0; line < LogModel.CAPACITY; line += LogModel.CAPACITY / 5) {
      int target = line;
      robot.interact(() -> list().scrollTo(target));
      commands(1);
      assertThat(cells()).hasSizeLessThan(MOST_CELLS);
    }
  }

  private void happens(SimEvent event) {
    logQueue.event(event);
    pulse();
  }

  private void commands(int count) {
    for (int i = 0; i < count; i++) {
      logQueue.event(
          new SimEvent.CommandReceived(SimTime.ZERO, 1, new Request(i, peer(), "forward " + i)));
      if (i % LogQueue.CAPACITY == LogQueue.CAPACITY - 1) {
        pulse();
      }
    }
    pulse();
  }

  private static Peer peer() {
    return new Peer(address("127.0.0.1", 9000), address("127.0.0.1", 8879));
  }

  /** Turns the mouse wheel over the list; up is positive [px]. */
  private void wheel(double pixels) {
    Node cell = cells().get(0);
    robot.interact(() -> cell.fireEvent(scroll(pixels)));
    pulse();
  }

  private static ScrollEvent scroll(double pixels) {
    ScrollEvent.VerticalTextScrollUnits none = ScrollEvent.VerticalTextScrollUnits.NONE;
    return new ScrollEvent(
        ScrollEvent.SCROLL,
        0,
        0,
        0,
        0,
        false,
        false,
        false,
        false,
        false,
        false,
        0,
        pixels,
        0,
        pixels,
        ScrollEvent.HorizontalTextScrollUnits.NONE,
        0,
        none,
        0,
        0,
        null);
  }

  /** Waits for a pulse of the window, and a second one after its layout. */
  private void pulse() {
    for (int i = 0; i < 2; i++) {
      robot.interact(() -> context.ticker().tick(0));
      robot.interact(() -> box.getScene().getRoot().layout());
    }
  }

  private Set<Node> timeStamps() {
    return robot.lookup(".log-time").queryAll();
  }

  private ListView<LogRow> list() {
    return robot.lookup("#log-list").queryListView();
  }

  private ToggleButton autoscroll() {
    return robot.lookup("#log-autoscroll").query();
  }

  private TextField search() {
    return robot.lookup("#log-search").query();
  }

  private Label matches() {
    return robot.lookup("#log-matches").query();
  }

  private List<String> shown() {
    return list().getItems().stream().map(row -> row.first().words(context.language())).toList();
  }

  private static String clipboard() {
    return onFxThread(() -> Clipboard.getSystemClipboard().getString());
  }

  private static <T> T onFxThread(Callable<T> question) {
    return WaitForAsyncUtils.waitForAsyncFx(10_000, question);
  }

  /** Returns the cells with a line, from top to bottom. */
  private List<ListCell<?>> cells() {
    Set<Node> found = robot.lookup("#log-list .list-cell").queryAll();
    return found.stream()
        .<ListCell<?>>map(node -> (ListCell<?>) node)
        .filter(cell -> !cell.isEmpty() && cell.isVisible())
        .sorted((one, other) -> Integer.compare(one.getIndex(), other.getIndex()))
        .toList();
  }

  /** Returns the indices of the lines of which at least half is visible. */
  private List<Integer> visible() {
    return inSight().stream().<Integer>map(ListCell::getIndex).toList();
  }

  private List<String> visibleWords() {
    return inSight().stream().map(cell -> textOf(cell, ".log-words")).toList();
  }

  private int lastVisible() {
    List<Integer> visible = visible();
    return visible.get(visible.size() - 1);
  }

  private List<ListCell<?>> inSight() {
    double height = list().getHeight();
    return cells().stream()
        .filter(
            cell -> {
              double middle = cell.getLayoutY() + cell.getHeight() / 2;
              return middle > 0 && middle < height;
            })
        .toList();
  }

  private static String textOf(Node cell, String selector) {
    return ((Label) cell.lookup(selector)).getText();
  }
}
