package tellosimulator.web;

import tellosimulator.control.Requests;
import tellosimulator.goal.GoalWatch;
import tellosimulator.network.OnlineSimulation;
import tellosimulator.scenario.OpenedScenario;
import tellosimulator.scenery.SceneBuilder;
import tellosimulator.sim.LastCommand;
import tellosimulator.video.VideoStreams;

/**
 * A scenario that is being flown, as pages show and control it.
 *
 * @param number the number of the scenario among those that were opened, from 1
 * @param scenes builds the scenes, with the textures that the drones' cameras use
 * @param requests carries out what a viewer asks for
 * @param lastCommand the latest command, a listener of the simulation
 * @param log the latest events, likewise
 */
public record WebSubject(
    int number,
    OpenedScenario opened,
    OnlineSimulation simulation,
    GoalWatch goals,
    VideoStreams video,
    SceneBuilder scenes,
    Requests requests,
    LastCommand lastCommand,
    EventHistory log) {

  /** Creates the subject, and begins to listen to the simulation. */
  public static WebSubject of(
      int number,
      OpenedScenario opened,
      OnlineSimulation simulation,
      GoalWatch goals,
      VideoStreams video,
      SceneBuilder scenes,
      Requests requests) {
    LastCommand lastCommand = new LastCommand();
    simulation.listen(lastCommand);
    EventHistory log = new EventHistory();
    simulation.listen(log.limited());
    return new WebSubject(
        number, opened, simulation, goals, video, scenes, requests, lastCommand, log);
  }
}
