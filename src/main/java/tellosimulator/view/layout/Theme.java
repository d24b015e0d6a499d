package tellosimulator.view.layout;

import atlantafx.base.theme.PrimerDark;
import atlantafx.base.theme.PrimerLight;
import javafx.scene.paint.Color;

/** The window's themes. */
public enum Theme {
  LIGHT(new PrimerLight().getUserAgentStylesheet(), Color.WHITE),
  DARK(new PrimerDark().getUserAgentStylesheet(), Color.web("#0d1117"));

  private final String stylesheet;
  private final Color background;

  Theme(String stylesheet, Color background) {
    this.stylesheet = stylesheet;
    this.background = background;
  }

  /** Returns the colour shown before the window is first drawn: the theme's background. */
  public Color background() {
    return background;
  }

  /** Returns the address of the style sheet, for {@code Application.setUserAgentStylesheet}. */
  public String stylesheet() {
    return stylesheet;
  }

  Theme other() {
    return this == LIGHT ? DARK : LIGHT;
  }
}
