package tellosimulator.view.layout;

import atlantafx.base.theme.PrimerDark;
import atlantafx.base.theme.PrimerLight;

/** How the window looks. */
public enum Theme {
  LIGHT(new PrimerLight().getUserAgentStylesheet()),
  DARK(new PrimerDark().getUserAgentStylesheet());

  private final String stylesheet;

  Theme(String stylesheet) {
    this.stylesheet = stylesheet;
  }

  /** For {@code Application.setUserAgentStylesheet}. */
  public String stylesheet() {
    return stylesheet;
  }

  Theme other() {
    return this == LIGHT ? DARK : LIGHT;
  }
}
