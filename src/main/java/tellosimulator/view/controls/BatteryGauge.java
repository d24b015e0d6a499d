package tellosimulator.view.controls;

import javafx.css.PseudoClass;
import javafx.scene.shape.Rectangle;
import javafx.scene.text.Text;
import tellosimulator.model.Battery;
import tellosimulator.view.fx.Nodes;
import tellosimulator.view.text.Messages;

/**
 * Shows the battery's charge as a partly filled battery symbol and a number. Confined to the JavaFX
 * thread.
 */
final class BatteryGauge extends Instrument {

  /** The ranges of the battery's charge. The drone's abilities differ from range to range. */
  enum Charge {
    /** Flips are possible. */
    GOOD(Battery.LEAST_FOR_FLIP),
    /** Flips are impossible. */
    FAIR(2 * Battery.TOO_LOW_FOR_TAKEOFF),
    /** Takeoff will soon be impossible. */
    LOW(Battery.TOO_LOW_FOR_TAKEOFF + 1),
    /** Takeoff is impossible, and the drone will soon land by itself. */
    CRITICAL(0);

    private final int least;

    Charge(int least) {
      this.least = least;
    }

    static Charge of(double percent) {
      for (Charge charge : values()) {
        if (percent >= charge.least) {
          return charge;
        }
      }
      return CRITICAL;
    }
  }

  private static final PseudoClass FAIR = PseudoClass.getPseudoClass("fair");
  private static final PseudoClass LOW = PseudoClass.getPseudoClass("low");
  private static final PseudoClass CRITICAL = PseudoClass.getPseudoClass("critical");

  /** Width of the battery's case [px]. */
  private static final double CASE_WIDTH = 30;

  /** Height of the case and of the whole gauge [px]. */
  private static final double HEIGHT = 16;

  /** Width of the whole gauge [px]. */
  private static final double WIDTH = 79;

  /** Gap between the case and its filling [px]. */
  private static final double GAP = 2.5;

  private final Messages messages;
  private final Rectangle filling = Nodes.styled(new Rectangle(), "filling");
  private final Text number = Nodes.named(new Text(), "battery-percent", "number");
  private double percent = Double.NaN;

  BatteryGauge(Messages messages) {
    super("battery", "battery-gauge", WIDTH, HEIGHT);
    this.messages = messages;
    initializeParts();
    layoutParts();
  }

  private void initializeParts() {
    filling.setX(GAP);
    filling.setY(GAP);
    filling.setHeight(HEIGHT - 2 * GAP);
    filling.setArcWidth(3);
    filling.setArcHeight(3);
  }

  private void layoutParts() {
    Rectangle body = new Rectangle(0.5, 0.5, CASE_WIDTH - 1, HEIGHT - 1);
    body.setArcWidth(6);
    body.setArcHeight(6);
    body.getStyleClass().add("case");
    Rectangle pole = Nodes.styled(new Rectangle(CASE_WIDTH, HEIGHT / 2 - 3, 2.5, 6), "pole");
    addShapes(body, pole, filling, CenteredText.rightAligned(number, WIDTH - 1, HEIGHT / 2));
  }

  /**
   * Shows a charge.
   *
   * @param newPercent the charge, 0 to 100 [%]
   */
  void show(double newPercent) {
    double whole = Math.rint(newPercent);
    if (whole == percent) {
      return;
    }
    percent = whole;
    filling.setWidth((CASE_WIDTH - 2 * GAP) * Math.max(0, Math.min(1, whole / 100)));
    number.setText(NumberText.whole(whole) + " %");
    Charge charge = Charge.of(whole);
    pseudoClassStateChanged(FAIR, charge == Charge.FAIR);
    pseudoClassStateChanged(LOW, charge == Charge.LOW);
    pseudoClassStateChanged(CRITICAL, charge == Charge.CRITICAL);
  }

  @Override
  String description() {
    return messages.now("battery.accessible", NumberText.whole(percent));
  }
}
