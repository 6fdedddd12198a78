% Responses by NLvib, as a line of JSON:
%
%     octave --no-gui --quiet nlvib_response.m FOLDER stop|damper
%
% FOLDER is that of NLvib. The stop is its example 3: two masses, a stop at the first, 21 harmonics, 1024 instants. The damper is that of VM320: an elastic dry friction element on one mass,
% nine harmonics, 1024 instants, in units of the slip force, of its displacement and of the mass on its spring. Octave's fsolve is given its options, since its optimset knows no function handles.
arguments = argv();
folder = arguments{1};
is_stop = strcmp(arguments{2}, 'stop');
addpath([folder '/SRC'], [folder '/SRC/MechanicalSystems']);
if is_stop
  element = struct('type', 'unilateralSpring', 'stiffness', 100, 'gap', 1, 'force_direction', [1; 0]);
  force = [0; 0.1];
  bodies = ChainOfOscillators([1 1], 0.03 * [0 1 1], [0 1 1], element, force);
  harmonics = 21; from = 0.8; to = 0.5806; step = 0.0085; held = 0; unit = 1; turns = 1;
else
  slips = 246.048; stiffness = 2.4e7; turns = sqrt(stiffness / 944.6); unit = slips / stiffness;
  element = {struct('type', 'elasticDryFriction', 'stiffness', 1, 'friction_limit_force', 1, 'ishysteretic', true, 'force_direction', 1)};
  force = 0.5;
  bodies = ChainOfOscillators(944.6 * unit / slips * turns^2, [7700 * unit / slips * turns 0], [1 0], element, force);
  harmonics = 9; from = 0.9; to = 1.7; step = 0.005; held = 1;
end
n = bodies.n;
linear = (-from^2 * bodies.M + 1i * from * bodies.D + bodies.K + held) \ force;
guess = zeros((2 * harmonics + 1) * n, 1);
guess(n + (1:2 * n)) = [real(linear); -imag(linear)];
scales = struct('Dscale', [ones(size(guess)); from]);
options = optimset('Display', 'off', 'Jacobian', 'on', 'MaxIter', 50, 'TolFun', 1e-6, 'TolX', 1e-6, 'Updating', 'off');
start = tic;
found = solve_and_continue(guess, @(x) HB_residual(x, bodies, harmonics, 1024, 'FRF'), from, to, step, scales, {}, options);
seconds = toc(start);
first = found(1:n:end - 1, :);
if is_stop
  sizes = sqrt(first(1, :).^2 + sum(first(2:end, :).^2, 1) / 2);
else
  sizes = sqrt(first(2, :).^2 + first(3, :).^2);
end
[peak, at] = max(sizes);
told = struct('seconds', seconds, 'points', columns(found), 'peak', peak * unit, 'frequency', found(end, at) * turns);
printf('%s\n', jsonencode(told));
