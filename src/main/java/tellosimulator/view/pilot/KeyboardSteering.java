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
 * Flies the selected drone by keyboard, through commands. For the JavaFX thread; it moves on with
 * the pulse.
 *
 * <p>While it is active and the drone flies, it repeats its {@code rc}, so that the drone does not
 * land for want of commands; when it is switched off, the sticks are centred, and the drone lands
 * by itself 15 s later. At very high time factors (above about 200) the repetition comes too late.
 */
public final class KeyboardSteering {

  /** How far a key pushes a stick. Decided: fast enough to see; up to 20 a drone may not react. */
  private static final int NORMAL = 60;

  /** The same with Shift. */
  private static final int FAST = 100;

  /** Shortest time between two {@code rc} [ns]. Decided: as operator programs with joysticks. */
  private static final long SHORTEST_NANOS = 50_000_000;

  /** After which {@code rc} is repeated [s, simulated]. Documented: safety landing after 15 s. */
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
    active.addListener(changed -> release());
    context.pulse().onBeat(this::beat);
    context.simulation().selectedProperty().addListener((observed, before, now) -> letGo(before));
  }

  /** Listens to the keys of a scene until the subscription ends; to be called once. */
  Subscription install(Scene newScene) {
    scene = Optional.of(newScene);
    EventHandler<KeyEvent> taking = this::take;
    newScene.addEventFilter(KeyEvent.ANY, taking);
    Subscription listening = () -> newScene.removeEventFilter(KeyEvent.ANY, taking);
    return listening
        .and(newScene.focusOwnerProperty().subscribe(owner -> releaseIfElsewhere()))
        .and(
            newScene
                .windowProperty()
                .flatMap(Window::focusedProperty)
                .orElse(true)
                .subscribe(this::releaseUnless));
  }

  /** Whether keys fly the drone. */
  public BooleanProperty activeProperty() {
    return active;
  }

  /** The keys that are held down. */
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
   * Whether keys are for something else: a text field, or a control that was reached by keyboard,
   * which one sees. What was only clicked leaves them to the drone.
   */
  private boolean elsewhere() {
    Optional<Node> owner = scene.map(Scene::getFocusOwner);
    return owner.filter(KeyboardSteering::takesKeys).isPresent();
  }

  private static boolean takesKeys(Node owner) {
    return owner instanceof TextInputControl
        || (owner instanceof Control && owner.isFocusVisible());
  }

  private void releaseIfElsewhere() {
    if (elsewhere()) {
      release();
    }
  }

  private void releaseUnless(boolean focused) {
    if (!focused) {
      release();
    }
  }

  private void release() {
    pressed.clear();
  }

  /** The keys fly a drone only while it is selected; it must not fly on with pushed sticks. */
  private void letGo(FxDroneModel before) {
    active.set(false);
    if (!sent.equals(CENTERED) && before.onProperty().get()) {
      remote.tell(before, CENTERED);
    }
    sent = CENTERED;
  }

  private void beat(long nanos) {
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
