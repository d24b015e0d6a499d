/**
 * What tests of the window stand on.
 *
 * <p>{@link tellosimulator.view.testing.WindowFixture} shows a view on a running simulation and
 * finds its nodes by their ids. A {@code *FxTest} runs without a display, by Monocle, and has no
 * 3D. A {@code *DisplayTest} is marked with {@link tellosimulator.view.testing.NeedsDisplay}: it
 * runs on a display that can do 3D, in a JVM of its own, and is skipped where there is none, except
 * on a build server. The executions of surefire in the project's pom choose by these names.
 */
package tellosimulator.view.testing;
