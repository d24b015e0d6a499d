package tellosimulator.view.controls;

import java.util.List;
import javafx.scene.control.Label;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.sim.Control;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Messages;
import tellosimulator.world.Wind;

/**
 * The wind: where it blows, how fast, and how much it changes, with directions as in scenario
 * files. What a person changes goes to the simulation at the next pulse, and what the simulation
 * says is shown. For the JavaFX thread.
 */
final class WindPanel extends Card {

  /** Degrees counter-clockwise seen from above, 0 towards the front wall. */
  private static final NumberRange TOWARDS = new NumberRange(-180, 180, 15);

  /** What the sliders reach [cm/s]. Decided: a wind against which a drone just holds its place. */
  private static final NumberRange SPEED = new NumberRange(0, 500, 10);

  private static final NumberRange GUSTS = new NumberRange(0, 200, 5);

  private static final NumberRange FIELD =
      new NumberRange(0, Frames.centimeters(Wind.FASTEST), SPEED.step());

  /** Slower is calm to the eye [m/s]; there is no direction left in it. */
  private static final double CALM = 1e-6;

  private final FxSimulation simulation;
  private final SimulatorActions actions;
  private final Messages messages;
  private final NumberSlider towards;
  private final NumberSlider speed;
  private final NumberSlider gusts;

  /** What is seen of it while it is folded. */
  private final Label now = new Label();

  WindPanel(ViewContext context) {
    super("wind", context.language().messages(WindPanel.class).text("wind.heading"));
    simulation = context.simulation();
    actions = context.actions();
    messages = context.language().messages(WindPanel.class);
    towards =
        new NumberSlider(
            "wind-towards", messages.text("wind-towards"), TOWARDS, context.language());
    speed = new NumberSlider("wind-speed", messages.text("wind-speed"), SPEED, context.language());
    gusts = new NumberSlider("wind-gusts", messages.text("wind-gusts"), GUSTS, context.language());
    List.of(speed, gusts).forEach(slider -> slider.setFieldRange(FIELD));
    Tooltips.install(towards, messages.text("wind-towards.hint"));
    Tooltips.install(gusts, messages.text("wind-gusts.hint"));
    now.setId("wind-now");
    now.getStyleClass().add("number");
    layoutHead(now);
    layoutCard(towards, speed, gusts);
    towards.show(0);
    show(wind());
    context.pulse().onBeat(nanos -> beat());
  }

  private void beat() {
    boolean changed = towards.takeChange();
    changed |= speed.takeChange();
    changed |= gusts.takeChange();
    if (changed) {
      actions.carryOut(new Control.SetWind(wanted()));
    } else if (!actions.pending()) {
      show(wind());
    }
  }

  private Wind wind() {
    return simulation.arenaProperty().get().wind();
  }

  private void show(Wind wind) {
    double mean = wind.mean().horizontal().norm();
    if (mean > CALM) {
      double degrees = Math.toDegrees(Math.atan2(wind.mean().y(), wind.mean().x()));
      towards.show(tidy(degrees));
    }
    speed.show(tidy(Frames.centimeters(mean)));
    now.setText(messages.now("wind.now", Math.round(Frames.centimeters(mean))));
    now.setVisible(mean > CALM);
    gusts.show(tidy(Frames.centimeters(wind.gusts())));
  }

  /** Without the last bits of the conversion. */
  private static double tidy(double number) {
    return Math.rint(number * 1000) / 1000;
  }

  private Wind wanted() {
    double angle = Math.toRadians(towards.value());
    double mean = Frames.meters(speed.value());
    return new Wind(
        new Vec3(Math.cos(angle) * mean, Math.sin(angle) * mean, wind().mean().z()),
        Frames.meters(gusts.value()));
  }
}
