package tellosimulator.view.pilot;

import java.util.EnumSet;
import java.util.Locale;
import java.util.Optional;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.SimpleBooleanProperty;
import javafx.collections.FXCollections;
import javafx.collections.ObservableSet;
import javafx.event.EventHandler;
import javafx.scene.Node;
import javafx.scene.Scene;
import javafx.scene.control.Control;
import javafx.scene.control.TextInputControl;
import javafx.scene.input.KeyEvent;
import javafx.stage.Window;
import javafx.util.Subscription;
import tellosimulator.view.model.FxDroneModel;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.pilot.SteeringKey.Push;

/**
 * Lets the user fly the selected drone with the keyboard, by sending commands. Confined to the
 * JavaFX thread; advances with the UI ticks.
 *
 * <p>While keyboard flight is on, the last {@code rc} is repeated in the air, so that the drone
 * does not land for lack of commands. Switching keyboard flight off centres the sticks, and the
 * drone lands by itself 15 s later. At very high time factors (above about 200), the repetition
 * comes too late.
 */
public final class KeyboardSteering {

  /**
   * Stick deflection of a key, from 0 to 100 as in {@code rc}. Decided: visibly fast. A drone may
   * ignore values up to 20.
   */
  private static final int NORMAL = 60;

  /** Stick deflection of a key with Shift: the maximum of {@code rc}. */
  private static final int FAST = 100;

  /** Minimum interval between two {@code rc} commands [ns]. Decided: as in joystick programs. */
  private static final long SHORTEST_NANOS = 50_000_000;

  /**
   * Interval after which {@code rc} is repeated [simulated s]. Documented: the drone lands after 15
   * s without commands.
   */
  private static final double REPETITION = 2;

  private static final String CENTERED = rc(Push.NONE, 0);

  private final ViewContext context;
  private final RemoteControl remote;
  private final BooleanProperty active = new SimpleBooleanProperty();
  private final ObservableSet<SteeringKey> pressed =
      FXCollections.observableSet(EnumSet.noneOf(SteeringKey.class));
  private final ObservableSet<SteeringKey> readOnlyPressed =
      FXCollections.unmodifiableObservableSet(pressed);
  private Optional<Scene> scene = Optional.empty();
  private String sent = CENTERED;
  private long sentNanos;
  private double sentSeconds;

  public KeyboardSteering(ViewContext context, RemoteControl remote) {
    this.context = context;
    this.remote = remote;
    active.addListener(changed -> pressed.clear());
    context.ticker().onTick(this::tick);
    context.simulation().selectedProperty().addListener((observed, before, now) -> letGo(before));
  }

  /** Handles the keys of a scene until the subscription ends. Must be called only once. */
  Subscription install(Scene newScene) {
    scene = Optional.of(newScene);
    EventHandler<KeyEvent> taking = this::take;
    newScene.addEventFilter(KeyEvent.ANY, taking);
    Subscription listening = () -> newScene.removeEventFilter(KeyEvent.ANY, taking);
    return listening
        .and(newScene.focusOwnerProperty().subscribe(owner -> releaseIf(elsewhere())))
        .and(
            newScene
                .windowProperty()
                .flatMap(Window::focusedProperty)
                .orElse(true)
                .subscribe(focused -> releaseIf(!focused)));
  }

  /** Whether keyboard flight is on. */
  public BooleanProperty activeProperty() {
    return active;
  }

  /** The pressed keys. */
  ObservableSet<SteeringKey> pressed() {
    return readOnlyPressed;
  }

  private void take(KeyEvent event) {
    Optional<SteeringKey> key = SteeringKey.of(event.getCode());
    boolean ours =
        active.get()
            && key.isPresent()
            && !elsewhere()
            && !event.isControlDown()
            && !event.isAltDown()
            && !event.isMetaDown();
    if (event.getEventType() == KeyEvent.KEY_RELEASED) {
      key.ifPresent(pressed::remove);
    } else if (ours && event.getEventType() == KeyEvent.KEY_PRESSED && pressed.add(key.get())) {
      act(key.get());
    }
    if (ours && key.get() != SteeringKey.FASTER) {
      event.consume();
    }
  }

  private void act(SteeringKey key) {
    switch (key) {
      case TAKE_OFF_OR_LAND -> remote.takeOffOrLand();
      case FLIP -> remote.ask("flip f");
      case EMERGENCY -> remote.tell("emergency");
      default -> {}
    }
  }

  /**
   * Returns whether keys belong to another control: a text field, or a control that was reached by
   * keyboard and shows its focus. A control that was only clicked does not take keys from the
   * drone.
   */
  private boolean elsewhere() {
    Node owner = scene.map(Scene::getFocusOwner).orElse(null);
    return owner instanceof TextInputControl
        || (owner instanceof Control && owner.isFocusVisible());
  }

  private void releaseIf(boolean lost) {
    if (lost) {
      pressed.clear();
    }
  }

  /**
   * Deactivates keyboard flight when another drone is selected. Centres the sticks of the previous
   * drone, so that it stops.
   */
  private void letGo(FxDroneModel before) {
    active.set(false);
    if (!sent.equals(CENTERED) && before.onProperty().get()) {
      remote.tell(before, CENTERED);
    }
    sent = CENTERED;
  }

  private void tick(long nanos) {
    boolean waits = nanos - sentNanos < SHORTEST_NANOS;
    if (waits || !context.simulation().selected().onProperty().get()) {
      return;
    }
    double seconds = context.simulation().secondsProperty().get();
    String wanted = wanted();
    boolean repeats =
        active.get() && remote.phase().flying() && seconds - sentSeconds >= REPETITION;
    if (repeats || !wanted.equals(sent)) {
      remote.tell(wanted);
      sent = wanted;
      sentNanos = nanos;
      sentSeconds = seconds;
    }
  }

  private String wanted() {
    Push sum = pressed.stream().map(SteeringKey::push).reduce(Push.NONE, Push::plus);
    return rc(sum, pressed.contains(SteeringKey.FASTER) ? FAST : NORMAL);
  }

  private static String rc(Push push, int strength) {
    return String.format(
        Locale.ROOT,
        "rc %d %d %d %d",
        push.right() * strength,
        push.forward() * strength,
        push.up() * strength,
        push.clockwise() * strength);
  }
}
