package tellosimulator.view.app;

import static org.assertj.core.api.Assertions.assertThat;
import static tellosimulator.view.testing.WindowFixture.onFxThread;
import static tellosimulator.view.testing.WindowFixture.waitQuietlyUntil;
import static tellosimulator.view.testing.WindowFixture.waitUntil;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import javafx.event.Event;
import javafx.event.EventTarget;
import javafx.scene.control.Label;
import javafx.scene.input.KeyCode;
import javafx.scene.input.KeyEvent;
import javafx.scene.input.MouseButton;
import javafx.scene.input.MouseEvent;
import javafx.stage.Popup;
import javafx.stage.Window;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tellosimulator.scenery.drone.StatusLight;
import tellosimulator.sim.Control;
import tellosimulator.sim.SimConfig;
import tellosimulator.sim.SimSnapshot;
import tellosimulator.view.layout.WindowState.Flag;
import tellosimulator.view.model.FxDroneModel;

/** The window while nothing moves, and the events that wake it. */
class IdleWindowFxTest {

  private static final long CALM_SECONDS = 2;

  /** The longest period of drawings in an idle window. */
  private static final double LONGEST_PERIOD_SECONDS = 2;

  @TempDir private Path folder;
  private final AtomicLong lastNanos = new AtomicLong();
  private WholeWindow window;

  @BeforeEach
  void open() {
    window = WholeWindow.open(SimConfig.DEFAULT, folder.resolve("settings"));
    window.change(() -> window.context().ticker().onTick(lastNanos::set));
    waitUntil(() -> lastNanos.get() != 0);
  }

  @AfterEach
  void close() {
    window.close();
  }

  @Test
  void withoutPowerItIsIdle() {
    becomeIdle();

    assertThat(idle()).isTrue();
  }

  @Test
  void aMouseThatMovesWakesIt() {
    becomeIdle();

    assertThat(onFxThread(() -> wakes(window.stage().getScene(), moved()))).isTrue();
  }

  @Test
  void soDoesOneInAListThatPopsUp() {
    Popup list = onFxThread(this::openPopup);
    becomeIdle();

    assertThat(onFxThread(() -> wakes(list.getScene(), moved()))).isTrue();

    window.change(list::hide);
  }

  private Popup openPopup() {
    Popup list = new Popup();
    list.getContent().add(new Label("a choice"));
    list.show(window.stage());
    return list;
  }

  @Test
  void aKeyWakesItBeforeTheKeyIsTaken() {
    becomeIdle();

    assertThat(
            onFxThread(
                () ->
                    wakes(
                        window.stage().getScene(),
                        new KeyEvent(
                            KeyEvent.KEY_PRESSED, "", "", KeyCode.F7, false, false, false, false))))
        .isTrue();
  }

  @Test
  void aCommandWakesItAndIsInTheLog() {
    window.switchOn();
    becomeIdle();

    window.fly("command");

    waitUntil(() -> !idle());
    waitUntil(() -> window.log().stream().anyMatch(line -> line.contains("command")));
  }

  @Test
  void aFlyingDroneKeepsItAwakeUntilTimeStandsStill() {
    window.switchOn();
    window.fly("command", "takeoff");
    assertThat(becomesIdle()).as("in flight").isFalse();

    window.carryOut(new Control.Pause(true));

    becomeIdle();
  }

  @Test
  void whatHappenedLastIsShown() {
    window.switchOn();
    window.fly("command", "takeoff", "land");
    becomeIdle();

    FxDroneModel drone = window.context().simulation().selected();
    assertThat(onFxThread(() -> drone.snapshotProperty().get().state().phase()))
        .isEqualTo(window.simulation().snapshot().drones().get(0).state().phase());
    assertThat(onFxThread(() -> drone.poseProperty().get()))
        .isEqualTo(window.simulation().snapshot().drones().get(0).state().motion().pose());
  }

  @Test
  void theClockGoesOn() {
    becomeIdle();
    double before = onFxThread(() -> window.context().simulation().secondsProperty().get());

    waitUntil(() -> window.context().simulation().secondsProperty().get() > before + 0.5);

    assertThat(idle()).isTrue();
  }

  /** A clock in a hidden panel would cause the whole window to be redrawn. */
  @Test
  void idleItDrawsNothing() {
    window.change(() -> window.state().flag(Flag.NETWORK_CONTROLS).set(false));
    AtomicInteger frames = new AtomicInteger();
    window.change(
        () -> window.stage().getScene().addPostLayoutPulseListener(frames::incrementAndGet));
    waitUntil(() -> frames.get() > 0);
    window.change(() -> window.stage().getScene().getRoot().requestFocus()); // no caret blinks
    becomeIdle();
    passSimulated(LONGEST_PERIOD_SECONDS); // the last change is drawn

    int spans = 0;
    double lost;
    do { // a tooltip below the mouse causes frames for up to six seconds
      lost = newest().clock().lostSeconds();
      frames.set(0);
      passSimulated(2 * LONGEST_PERIOD_SECONDS);
      spans += newest().clock().lostSeconds() == lost ? 1 : 0; // losing time is shown
    } while (frames.get() > 0 && spans < 4);

    assertThat(idle()).isTrue();
    assertThat(frames)
        .as(
            "windows %s, focus on %s",
            onFxThread(() -> List.copyOf(Window.getWindows())),
            onFxThread(() -> window.stage().getScene().getFocusOwner()))
        .hasValue(0);
  }

  @Test
  void itsLampIsSteady() {
    window.switchOn();
    StatusLight first = lamp();
    waitUntil(
        () -> {
          window.context().ticker().wake();
          return lamp() != first; // it blinks
        });

    becomeIdle();
    waitUntil(() -> !window.context().simulation().pictured().equals(newest()));

    StatusLight steady = lamp();
    for (int i = 0; i < 20; i++) {
      passSimulated(0.05);
      assertThat(lamp()).isSameAs(steady);
    }
  }

  @Test
  void whileTimeStandsStillTheLampDoesNotChange() {
    window.switchOn();
    window.carryOut(new Control.Pause(true));
    waitUntil(() -> newest().clock().paused());
    StatusLight paused = lamp();

    for (int i = 0; i < 20; i++) {
      window.change(() -> window.context().ticker().wake());
      window.passFrames(2); // it blinks five times a second

      assertThat(lamp()).isSameAs(paused);
    }
  }

  /** Returns the latest snapshot that the window has mirrored. */
  private SimSnapshot newest() {
    return window.context().simulation().snapshot();
  }

  private void passSimulated(double seconds) {
    double until = window.simulation().snapshot().time().seconds() + seconds;
    waitQuietlyUntil(() -> window.simulation().snapshot().time().seconds() >= until);
  }

  /** Returns the drone's lamp as the window shows it. */
  private StatusLight lamp() {
    return onFxThread(() -> StatusLight.seen(window.context().simulation().selected().pictured()));
  }

  private boolean wakes(EventTarget target, Event event) {
    boolean before = idle();
    Event.fireEvent(target, event);
    return before && !idle();
  }

  private static MouseEvent moved() {
    return new MouseEvent(
        MouseEvent.MOUSE_MOVED,
        9,
        9,
        9,
        9,
        MouseButton.NONE,
        0,
        false,
        false,
        false,
        false,
        false,
        false,
        false,
        true,
        false,
        true,
        null);
  }

  private boolean idle() {
    return window.context().ticker().idle();
  }

  private void becomeIdle() {
    waitUntil(this::becomesIdle);
  }

  /** Returns whether the window becomes idle after two seconds without events. */
  private boolean becomesIdle() {
    return onFxThread(
        () -> {
          window.context().ticker().tick(lastNanos.get() + CALM_SECONDS * 1_000_000_000);
          return idle();
        });
  }
}
