package tellosimulator.view.controls;

import java.util.List;
import javafx.scene.control.Label;
import tellosimulator.math.Frames;
import tellosimulator.math.Vec3;
import tellosimulator.scenario.Quantity;
import tellosimulator.sim.Control;
import tellosimulator.view.fx.Tooltips;
import tellosimulator.view.model.FxSimulation;
import tellosimulator.view.model.SimulatorActions;
import tellosimulator.view.model.ViewContext;
import tellosimulator.view.text.Messages;
import tellosimulator.world.Wind;

/**
 * Controls for the wind's direction, speed and gusts. Directions are as in scenario files. Changes
 * are sent to the simulation at the next pulse; the panel shows the values of the simulation.
 * Confined to the JavaFX thread.
 */
final class WindPanel extends Card {

  /**
   * The range of directions towards which the wind blows [deg]: counter-clockwise as seen from
   * above, with 0 towards the front wall.
   */
  private static final NumberRange TOWARDS = new NumberRange(-180, 180, 15);

  /**
   * The range of the sliders [cm/s]. Decided: the maximum is a wind in which a drone barely holds
   * its position.
   */
  private static final NumberRange SPEED = new NumberRange(0, 500, 10);

  private static final NumberRange GUSTS = new NumberRange(0, 200, 5);

  private static final NumberRange FIELD = new NumberRange(Quantity.WIND_SPEED, SPEED.step());

  /** Speed below which the wind is shown as calm and has no direction [m/s]. */
  private static final double CALM = 1e-6;

  private final FxSimulation simulation;
  private final SimulatorActions actions;
  private final Messages messages;
  private final NumberSlider towards;
  private final NumberSlider speed;
  private final NumberSlider gusts;

  /** Shows the speed, even while the card is folded. */
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
    context.ticker().onTick(nanos -> beat());
  }

  private void beat() {
    NumberSlider.advance(
        actions, () -> new Control.SetWind(wanted()), () -> show(wind()), towards, speed, gusts);
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

  /** Removes the rounding errors of the conversion. */
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
