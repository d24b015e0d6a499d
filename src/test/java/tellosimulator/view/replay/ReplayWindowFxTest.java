package tellosimulator.view.replay;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static tellosimulator.view.testing.WindowFixture.onFxThread;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import javafx.beans.property.SimpleObjectProperty;
import javafx.scene.control.ChoiceBox;
import javafx.scene.control.Label;
import javafx.scene.control.ListView;
import javafx.scene.control.Slider;
import javafx.scene.image.Image;
import javafx.scene.image.ImageView;
import javafx.scene.image.PixelFormat;
import javafx.scene.input.KeyCode;
import javafx.stage.Stage;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.testfx.api.FxRobot;
import org.testfx.api.FxToolkit;
import tellosimulator.recording.RecordingFixture;
import tellosimulator.recording.UnreadableRecordingException;
import tellosimulator.report.ReportEntry;
import tellosimulator.video.camera.DroneOptics;
import tellosimulator.view.layout.Theme;
import tellosimulator.view.replay.ReplayWindow.Appearance;
import tellosimulator.view.testing.QuickRobot;
import tellosimulator.view.text.Language;

/** The player with a recording from 1 to 15 s: takeoff at 4 s, 100 cm forward from 8 s on. */
class ReplayWindowFxTest {

  @TempDir private Path folder;
  private final FxRobot robot = new QuickRobot();
  private ReplayWindow window;
  private Stage stage;

  @BeforeEach
  void open() throws Exception {
    FxToolkit.registerPrimaryStage();
    open(DroneOptics.DEFAULT);
  }

  private void open(DroneOptics optics) throws UnreadableRecordingException {
    ReplayFlight flight = ReplayFlight.read(RecordingFixture.in(folder.resolve("first")));
    onFxThread(
        () -> {
          stage = new Stage();
          window =
              new ReplayWindow(
                  stage,
                  flight,
                  new Appearance(
                      new Language(Locale.ENGLISH),
                      new SimpleObjectProperty<>(Theme.LIGHT),
                      optics));
          window.show();
          return window;
        });
  }

  @AfterEach
  void close() {
    onFxThread(
        () -> {
          window.close();
          stage.hide();
          return window;
        });
  }

  @Test
  void arrowsStepAndHomeAndEndJump() {
    robot.press(KeyCode.END).release(KeyCode.END);
    waitUntil(() -> moment() == 15);
    robot.press(KeyCode.LEFT).release(KeyCode.LEFT);
    waitUntil(() -> Math.abs(moment() - 14.9) < 1e-6);
    robot.press(KeyCode.SHIFT, KeyCode.LEFT).release(KeyCode.LEFT, KeyCode.SHIFT);
    waitUntil(() -> Math.abs(moment() - 13.9) < 1e-6);
    robot.press(KeyCode.HOME).release(KeyCode.HOME);

    waitUntil(() -> moment() == 1);
  }

  @Test
  void plusAndMinusChangeTheSpeedOnAllKeyboards() {
    type(KeyCode.PLUS);
    waitUntil(() -> speed() == 2);
    robot.press(KeyCode.SHIFT, KeyCode.EQUALS).release(KeyCode.EQUALS, KeyCode.SHIFT);
    waitUntil(() -> speed() == 4);
    type(KeyCode.ADD);
    waitUntil(() -> speed() == 8);
    type(KeyCode.MINUS);
    type(KeyCode.SUBTRACT);
    waitUntil(() -> speed() == 2);
    type(KeyCode.EQUALS);
    waitUntil(() -> speed() == 4);
  }

  @Test
  void theListFollowsAndAChosenEntryIsGoneTo() {
    ListView<?> list = robot.lookup("#entry-list").queryListView();
    seek(9.2);
    waitUntil(() -> text(list.getSelectionModel().getSelectedItem()).equals("cw 90"));

    onFxThread(
        () -> {
          list.getSelectionModel().selectFirst();
          return list;
        });

    waitUntil(() -> moment() == 1);
  }

  @Test
  void theDroneIsWhereItWasAndItsGhostIsAsFarAwayAsItWasThen() throws Exception {
    seek(9); // 1 s after it started to fly 50 cm/s from -100 cm
    waitUntil(() -> label("place").equals("x -50, y 50, z 80 cm"));

    Path late = folder.resolve("late");
    new RecordingFixture(late).runWith("\"started\":4.0", "\"started\":3.0").samples(15);
    ReplayFlight ghost = ReplayFlight.read(late);
    onFxThread(
        () -> {
          window.compareWith(Optional.of(ghost));
          return window;
        });

    // the same time after its takeoff is 8 s, when it had not moved yet
    waitUntil(() -> label("distance").equals("The ghost is 50 cm away"));
    assertThat(label("ghost-name")).isEqualTo("Ghost: late");
  }

  @Test
  void theDronesCameraIsTheOneThatTheCommandLineDescribes() throws Exception {
    int[] usual = droneCamera();
    close();
    open(DroneOptics.DEFAULT);
    assertThat(droneCamera()).as("from the same camera").isEqualTo(usual);
    close();

    open(new DroneOptics(DroneOptics.DEFAULT.fieldOfView(), Math.toRadians(90), 640));

    assertThat(droneCamera()).as("straight down").isNotEqualTo(usual);
  }

  /** Returns the first picture of the drone's camera. */
  private int[] droneCamera() {
    type(KeyCode.F6);
    ImageView inset = robot.lookup("#inset-picture").queryAs(ImageView.class);
    waitUntil(() -> inset.getImage() != null);
    return onFxThread(
        () -> {
          Image image = inset.getImage();
          int width = (int) image.getWidth();
          int height = (int) image.getHeight();
          int[] pixels = new int[width * height];
          image
              .getPixelReader()
              .getPixels(0, 0, width, height, PixelFormat.getIntArgbInstance(), pixels, 0, width);
          return pixels;
        });
  }

  @Test
  void spacePlaysAndPauses() {
    robot.press(KeyCode.SPACE).release(KeyCode.SPACE);
    waitUntil(() -> moment() > 1.2);
    robot.press(KeyCode.SPACE).release(KeyCode.SPACE);
    double paused = onFxThread(this::moment);

    seek(paused);
    assertThat(onFxThread(this::moment)).isCloseTo(paused, within(1e-6));
  }

  private void type(KeyCode key) {
    robot.press(key).release(key);
  }

  private double speed() {
    return (Double) robot.lookup("#speed").queryAs(ChoiceBox.class).getValue();
  }

  private void seek(double time) {
    onFxThread(
        () -> {
          slider().setValue(time);
          return time;
        });
  }

  private Slider slider() {
    return robot.lookup("#moment").queryAs(Slider.class);
  }

  private double moment() {
    return slider().getValue();
  }

  private String label(String id) {
    return robot.lookup("#" + id).queryAs(Label.class).getText();
  }

  private static String text(Object entry) {
    return entry instanceof ReportEntry shown ? shown.words().text() : "";
  }
}
