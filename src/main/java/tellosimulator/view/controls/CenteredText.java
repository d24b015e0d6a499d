package tellosimulator.view.controls;

import javafx.geometry.Bounds;
import javafx.scene.Group;
import javafx.scene.text.Text;

/**
 * A text that stays centred at a point when its content or font changes. A right-aligned text ends
 * at the point instead, and is centred only vertically.
 */
final class CenteredText extends Group {

  private final Text text;
  private final double x;
  private final double y;
  private final double share;

  CenteredText(Text text, double x, double y) {
    this(text, x, y, 0.5);
  }

  private CenteredText(Text text, double x, double y, double share) {
    this.text = text;
    this.x = x;
    this.y = y;
    this.share = share;
    getChildren().add(text);
    setManaged(false);
    text.layoutBoundsProperty().addListener((property, before, now) -> place());
    place();
  }

  static CenteredText rightAligned(Text text, double x, double y) {
    return new CenteredText(text, x, y, 1);
  }

  private void place() {
    Bounds bounds = text.getLayoutBounds();
    text.setTranslateX(x - bounds.getMinX() - bounds.getWidth() * share);
    text.setTranslateY(y - bounds.getMinY() - bounds.getHeight() / 2);
  }
}
